#include "sph/initial_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sph {
namespace {

using std::numbers::pi;

FlowAtPoint AtRest(Vec2, const FlowScale&) { return {}; }

/// p = rho g . (x - x_surface), the surface being at the level of the box's corner that is highest against gravity, so
/// that no pressure is negative.
FlowAtPoint Hydrostatic(Vec2 point, const FlowScale& scale) {
  const Vec2 weight = scale.density * scale.gravity;
  const Vec2 highest{weight.x > 0 ? scale.box.x0 : scale.box.x1, weight.y > 0 ? scale.box.y0 : scale.box.y1};
  return {{}, Dot(weight, point - highest)};
}

/// A wave that stands, as long as the fluid is wide, at the moment when its surface is flat and its speed greatest:
/// u = V sin kx cosh ky, v = -V cos kx sinh ky over the floor y = 0, with U = V sinh kH at the surface [A.
/// Souto-Iglesias et al. 2012, in the form of H. Lamb, Hydrodynamics, 1932, art. 228]. The pressure is the exact one of
/// that moment: by Bernoulli's theorem rho (g (H - y) + F - |u|^2/2), F being the harmonic function that is |u|^2/2 at
/// the surface, where |u|^2 = V^2/2 (cosh 2ky - cos 2kx).
FlowAtPoint StandingWave(Vec2 point, const FlowScale& scale) {
  const double k = 2 * pi / scale.box.Width();
  const double height = scale.box.Height();
  const double x = k * (point.x - scale.box.x0), y = k * (point.y - scale.box.y0);
  const double v = scale.speed / std::sinh(k * height);
  const double surface = std::cosh(2 * k * height), here = std::cosh(2 * y);
  const double dynamic = 0.25 * v * v * (surface - here + std::cos(2 * x) * (1 - here / surface));
  return {{v * std::sin(x) * std::cosh(y), -v * std::cos(x) * std::sinh(y)},
          Hydrostatic(point, scale).pressure + scale.density * dynamic};
}

/// u = -U cos kx sin ky, v = U sin kx cos ky, p = -rho U^2/4 (cos 2kx + cos 2ky), k = 2 pi/L [G. I. Taylor & A. E.
/// Green, Proc. R. Soc. A 158 (1937) 499].
FlowAtPoint TaylorGreen(Vec2 point, const FlowScale& scale) {
  const double x = 2 * pi * (point.x - scale.box.x0) / scale.box.Width();
  const double y = 2 * pi * (point.y - scale.box.y0) / scale.box.Height();
  const double u = scale.speed;
  return {{-u * std::cos(x) * std::sin(y), u * std::sin(x) * std::cos(y)},
          -0.25 * scale.density * u * u * (std::cos(2 * x) + std::cos(2 * y))};
}

/// u = U/sqrt 2 (1, -1) sin k(x + y), k = 2 pi/L, no pressure: shear at 45 degrees to the axes, which does not change
/// but for its decay.
FlowAtPoint ShearWave(Vec2 point, const FlowScale& scale) {
  const double x = (point.x - scale.box.x0) / scale.box.Width() + (point.y - scale.box.y0) / scale.box.Height();
  const double u = scale.speed / std::numbers::sqrt2 * std::sin(2 * pi * x);
  return {{u, -u}};
}

/// u = -A x, v = A y with A = U/R, p = rho A^2/2 (R^2 - r^2) in a disk [J. J. Monaghan, J. Comput. Phys. 110 (1994)
/// 399].
FlowAtPoint Stretching(Vec2 point, const FlowScale& scale) {
  const Vec2 from_centre = point - scale.box.Centre();
  const double radius = 0.5 * scale.box.Width();
  const double rate = scale.speed / radius;
  return {{-rate * from_centre.x, rate * from_centre.y},
          0.5 * scale.density * (rate * rate + scale.central) * (radius * radius - Dot(from_centre, from_centre))};
}

/// u = w y, v = -w x with w = 2U/L in a square of side L, lap p = 2 rho w^2, p = 0 on its sides, as a double sine
/// series [A. Colagrossi, PhD thesis, Rome 2005; in the form of D. Le Touze et al., Int. J. Numer. Methods Fluids 73
/// (2013) 660].
FlowAtPoint RotatingSquare(Vec2 point, const FlowScale& scale) {
  constexpr int kTerms = 60;
  const Vec2 from_centre = point - scale.box.Centre();
  const double side = scale.box.Width();
  const double rate = 2 * scale.speed / side;
  const double x = pi * (from_centre.x / side + 0.5), y = pi * (from_centre.y / side + 0.5);
  double sum = 0;
  for (int m = 1; m < kTerms; m += 2) {
    for (int n = 1; n < kTerms; n += 2) {
      sum += std::sin(m * x) * std::sin(n * y) / (m * n * pi * pi * (m * m + n * n));
    }
  }
  return {{rate * from_centre.y, -rate * from_centre.x},
          -32 * scale.density * rate * rate * side * side / (pi * pi) * sum};
}

/// rho = 2M/(pi R^2) (1 - r^2/R^2): the static toy star [Braune & Lewiner eq. 22], here moving as v = U x/R.
FlowAtPoint Star(Vec2 point, const FlowScale& scale) {
  const Vec2 from_centre = point - scale.box.Centre();
  const double radius = 0.5 * scale.box.Width();
  const double s2 = Dot(from_centre, from_centre) / (radius * radius);
  return {scale.speed / radius * from_centre, 0, 2 * scale.mass / (pi * radius * radius) * std::max(0.0, 1 - s2)};
}

FlowAtPoint StarAtRest(Vec2 point, const FlowScale& scale) {
  FlowAtPoint star = Star(point, scale);
  star.velocity = {};
  return star;
}

/// The same star, moving as v = U/R (x, -y).
FlowAtPoint EllipticStar(Vec2 point, const FlowScale& scale) {
  FlowAtPoint star = Star(point, scale);
  star.velocity.y = -star.velocity.y;
  return star;
}

}  // namespace

std::span<const InitialFlow> AllInitialFlows() {
  static const std::array flows = {
      InitialFlow{"rest", "no motion, reference density", &AtRest},
      InitialFlow{"hydrostatic", "no motion, pressure that carries the fluid above", &Hydrostatic, Weight::kAnyWay},
      InitialFlow{"standing-wave", "a wave between two walls, when its surface is flat", &StandingWave,
                  Weight::kDownwards},
      InitialFlow{"taylor-green", "a periodic array of vortices", &TaylorGreen},
      InitialFlow{"shear-wave", "a wave of shear at 45 degrees in a square that repeats", &ShearWave},
      InitialFlow{"stretching", "a drop that becomes an ellipse", &Stretching},
      InitialFlow{"star", "a toy star at rest", &StarAtRest},
      InitialFlow{"breathing-star", "a toy star that swells from its static size", &Star},
      InitialFlow{"elliptic-star", "a toy star that becomes an ellipse from its static shape", &EllipticStar},
      InitialFlow{"rotating-square", "a square that turns like a rigid body", &RotatingSquare},
  };
  return flows;
}

}  // namespace sph
