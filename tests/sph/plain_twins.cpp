#include "sph/plain_twins.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace sph {
namespace {

using std::numbers::pi;

/// Eq. 5 with the plane's constant, as it is printed otherwise.
double CubicSplineValue(double r, double h) {
  const double q = r / h;
  const double c = 5 / (14 * pi * h * h);
  if (q < 1) return c * (std::pow(2 - q, 3) - 4 * std::pow(1 - q, 3));
  if (q < 2) return c * std::pow(2 - q, 3);
  return 0;
}

/// dW/dr of it.
double CubicSplineSlope(double r, double h) {
  const double q = r / h;
  const double c = 5 / (14 * pi * h * h);
  if (q < 1) return c / h * (-3 * std::pow(2 - q, 2) + 12 * std::pow(1 - q, 2));
  if (q < 2) return c / h * -3 * std::pow(2 - q, 2);
  return 0;
}

/// Unit vector from j to i, or 0 where they coincide.
Vec2 Direction(const Cloud& p, std::size_t i, std::size_t j) {
  const Vec2 d{p.x[i] - p.x[j], p.y[i] - p.y[j]};
  const double r = Length(d);
  return r > 0 ? (1 / r) * d : Vec2{};
}

double Distance(const Cloud& p, std::size_t i, std::size_t j) { return std::hypot(p.x[i] - p.x[j], p.y[i] - p.y[j]); }

/// sums[i] = sum over j of term(i, j), a PlainSum of one term, among particles nearer than reach.
template <typename Term>
std::vector<PlainSum> SumOverPairs(const Cloud& cloud, double reach, bool with_itself, Term term) {
  std::vector<PlainSum> sums(cloud.Size());
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    for (std::size_t j = 0; j < cloud.Size(); ++j) {
      if ((i == j && !with_itself) || Distance(cloud, i, j) >= reach) continue;
      const PlainSum one = term(i, j);
      sums[i].value = sums[i].value + one.value;
      sums[i].size += one.size;
      ++sums[i].terms;
    }
  }
  return sums;
}

}  // namespace

double PlainSum::RoundOff() const {
  return (16 + static_cast<double>(terms)) * std::numeric_limits<double>::epsilon() * size;
}

std::vector<PlainSum> PlainDensity(const Cloud& cloud, double h) {
  return SumOverPairs(cloud, 2 * h, true, [&](std::size_t i, std::size_t j) {
    const double m = cloud.mass[j];
    return PlainSum{{m * CubicSplineValue(Distance(cloud, i, j), h), 0}, m * CubicSplineValue(0, h)};
  });
}

std::vector<PlainSum> PlainPoly6Density(const Cloud& cloud, double h) {
  return SumOverPairs(cloud, h, true, [&](std::size_t i, std::size_t j) {
    const double m = cloud.mass[j];
    const double r = Distance(cloud, i, j);
    return PlainSum{{m * 4 / (pi * std::pow(h, 8)) * std::pow(h * h - r * r, 3), 0}, m * 4 / (pi * h * h)};
  });
}

std::vector<PlainSum> PlainPressureAcceleration(const Cloud& cloud, std::span<const double> density,
                                                std::span<const double> pressure, double h) {
  const double steepest = std::abs(CubicSplineSlope(2 * h / 3, h));  // where W'' = 0
  return SumOverPairs(cloud, 2 * h, false, [&](std::size_t i, std::size_t j) {
    const double term_i = pressure[i] / (density[i] * density[i]);
    const double term_j = pressure[j] / (density[j] * density[j]);
    const double s = -cloud.mass[j] * (term_i + term_j) * CubicSplineSlope(Distance(cloud, i, j), h);
    return PlainSum{s * Direction(cloud, i, j), cloud.mass[j] * (std::abs(term_i) + std::abs(term_j)) * steepest};
  });
}

std::vector<PlainSum> PlainMuellerForces(const Cloud& cloud, std::span<const double> density,
                                         std::span<const double> pressure, double h, double mu, bool published) {
  const double h5 = std::pow(h, 5);
  return SumOverPairs(cloud, h, false, [&](std::size_t i, std::size_t j) {
    const double r = Distance(cloud, i, j);
    const double mean_pressure = (pressure[i] + pressure[j]) / 2;
    const double share = cloud.mass[j] / density[j] / density[i];
    const Vec2 from_j = Direction(cloud, i, j);
    // Right: -grad_i W along from_j. The tutorial: its r_ij is x_j - x_i, and the force is -r_ij/r p SPIKY_GRAD (h -
    // r)^3.
    const double slope = published ? -10 / (pi * h5) * std::pow(h - r, 3) : -30 / (pi * h5) * std::pow(h - r, 2);
    const Vec2 direction = published ? -1 * from_j : from_j;
    const Vec2 towards_v{cloud.vx[j] - cloud.vx[i], cloud.vy[j] - cloud.vy[i]};
    const double drag = mu * share * 40 / (pi * h5) * (h - r);
    const double greatest_slope = published ? 10 / (pi * h * h) : 30 / (pi * h * h * h);
    const double size = share * (0.5 * (std::abs(pressure[i]) + std::abs(pressure[j])) * greatest_slope +
                                 mu * 40 / (pi * std::pow(h, 4)) * (std::abs(towards_v.x) + std::abs(towards_v.y)));
    return PlainSum{-share * mean_pressure * slope * direction + drag * towards_v, size};
  });
}

}  // namespace sph
