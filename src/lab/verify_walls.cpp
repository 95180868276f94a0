// Flows along walls: water at rest, and flow between plates.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/clock.hpp"
#include "lab/reference_data.hpp"
#include "lab/verification.hpp"
#include "particles/diagnostics.hpp"

namespace sph {

std::vector<Verdict> MeasureStillWater(ParticleSystemSPH& system) {
  constexpr double kEnd = 2;
  const double gravity = -system.parameters.gravity.y;
  const double height = system.parameters.fluid.region.box.Height();
  const double rho0 = ReferenceDensity(system.parameters_sph.equation_of_state);
  AdvanceTo(system, kEnd);
  if (system.Trouble()) return {{"pressure", kBroken, 0, ""}, {"kinetic energy", kBroken, 0, ""}};
  system.ComputeFields();
  const Particles& p = system.State();
  const std::vector<double> pressure = system.Pressure();
  double squares = 0, mass = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double error = pressure[i] - rho0 * gravity * (height - p.y[i]);
    squares += error * error;
    mass += p.mass[i];
  }
  const double l2 = std::sqrt(squares / static_cast<double>(p.Size())) / (rho0 * gravity * height);
  return {{"L2 of pressure over rho g H at t = 2 s", l2, 0.0015, "rho g (H - y); best elsewhere 0.0035"},
          {"kinetic energy over M g H at t = 2 s", Diagnose(system).kinetic_energy / (mass * gravity * height), 1e-8,
           "0; best elsewhere 1.4e-7"}};
}

/// u = F/(2 nu) y (L - y) - sum over odd n of 4 F L^2/(nu pi^3 n^3) sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2) [J. P.
/// Morris, P. J. Fox and Y. Zhu, J. Comput. Phys. 136 (1997) 214, eq. 17].
std::vector<Verdict> MeasurePoiseuille(ParticleSystemSPH& system) {
  using std::numbers::pi;
  const Box box = system.parameters.fluid.region.box;
  const double width = box.Height();
  const double force = system.parameters.gravity.x;
  const double nu = system.parameters_sph.viscosity / ReferenceDensity(system.parameters_sph.equation_of_state);
  const double steady = force * width * width / (8 * nu);  // in the middle
  const auto exact = [&](double y, double t) {
    double u = force / (2 * nu) * y * (width - y);
    for (int n = 1; n < 40; n += 2) {
      const double wave = n * pi / width;
      u -=
          4 * force * width * width / (nu * std::pow(n * pi, 3)) * std::sin(wave * y) * std::exp(-wave * wave * nu * t);
    }
    return u;
  };
  const double slowest = width * width / (pi * pi * nu);  // [s], in which the profile approaches the steady one
  double worst = 0;
  for (const double share : {0.1, 0.3, 1.0, 3.0, 6.0}) {
    AdvanceTo(system, share * slowest);
    if (system.Trouble()) return {{"velocity", kBroken, 0.001, ""}};
    const Particles& p = system.State();
    double squares = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double error = p.vx[i] - exact(p.y[i] - box.y0, system.Time());
      squares += error * error;
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(p.Size())) / steady);
  }
  return {{"L2 of velocity over the steady greatest, worst of five times", worst, 0.001,
           "exact series; elsewhere 0.0020 to 0.0069"}};
}

/// The front's place over a against time over sqrt(a/(2g)), until it is near the far wall.
std::vector<Verdict> MeasureWaterColumn(ParticleSystemSPH& system) {
  constexpr double kNearTheWall = 3.95;
  const double width = system.parameters.fluid.region.box.Width();
  const double unit = std::sqrt(0.5 * width / -system.parameters.gravity.y);  // [s]
  const double half_a_particle = 0.5 * system.InitialSpacing();
  const Stopwatch watch;
  double squares = 0;
  int count = 0;
  for (const Vec2 point : ReadReference("koshizuka_oka1996_front_mps")) {
    if (point.y > kNearTheWall) break;
    AdvanceTo(system, unit * point.x);
    if (system.Trouble()) return {{"front", kBroken, 0.013, ""}, {"seconds per simulated second", kBroken, 4, ""}};
    const auto& x = system.State().x;
    const double front = (*std::max_element(x.begin(), x.end()) + half_a_particle) / width;
    squares += (front - point.y) * (front - point.y);
    ++count;
  }
  return {{"front, RMS difference over a", std::sqrt(squares / count), 0.013,
           "Koshizuka & Oka 1996, MPS; elsewhere 0.013 to 0.018"},
          {"seconds per simulated second", watch.Seconds() / system.Time(), 4,
           "elsewhere 15 (DFSPH) to 345, same particles, one core"}};
}

}  // namespace sph
