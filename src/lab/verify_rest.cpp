// Water that comes to rest from disorder, in tanks that no lattice fits, and under gravity that is tilted.
#include <algorithm>
#include <cmath>

#include "lab/fill_gauges.hpp"
#include "lab/verification.hpp"
#include "lab/water_at_rest.hpp"
#include "particles/diagnostics.hpp"

namespace sph {
namespace {

constexpr double kEnd = 20;            // [s]
constexpr double kApart = 0.1;         // [s] between two looks at the kinetic energy
constexpr double kMostKinetic = 2e-5;  // of M g H

/// Of the pressures of the last computed fields, over rho g H.
double PressureError(const ParticleSystemSPH& system, const WaterAtRest& rest) {
  const Particles& p = system.State();
  const std::vector<double> pressure = system.Pressure();
  double squares = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double error = pressure[i] - rest.Pressure(p.Position(i));
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(p.Size())) / (rest.rho0 * Length(rest.gravity) * rest.Height());
}

/// Mean kinetic energy until then [J/m].
double MeanKineticEnergy(ParticleSystemSPH& system, double until) {
  double sum = 0;
  int looks = 0;
  for (double time = system.Time() + kApart; time < until + 0.5 * kApart; time += kApart, ++looks) {
    AdvanceTo(system, time);
    sum += Diagnose(system).kinetic_energy;
  }
  return sum / looks;
}

}  // namespace

std::vector<Verdict> MeasureRest(ParticleSystemSPH& system) {
  const WaterAtRest rest = RestOf(system, system.State());
  AdvanceTo(system, 0.5 * kEnd);
  const double before = MeanKineticEnergy(system, 0.75 * kEnd);
  const double after = MeanKineticEnergy(system, kEnd);
  system.ComputeFields();
  const bool broken = system.Trouble().has_value();
  const auto value = [&](auto measure) { return broken ? kBroken : measure(); };
  const double height = rest.Height();
  const auto surface = [&] {
    const Trough trough{rest.tank.x0, rest.tank.x1, rest.tank.y0};
    return FilledHeight(system.State(), trough, system.InitialSpacing()) / height - 1;
  };
  const double weight = rest.mass * Length(rest.gravity) * height;
  // Water that moves less than a tenth of what it may is said to be at rest.
  const double still = 0.1 * kMostKinetic * weight;
  return {{.metric = "L2 of pressure over rho g H at t = 20 s",
           .value = value([&] { return PressureError(system, rest); }),
           .bar = 0.02,
           .reference = "hydrostatic, exact"},
          {.metric = "kinetic energy over M g H at t = 20 s",
           .value = value([&] { return Diagnose(system).kinetic_energy / weight; }),
           .bar = kMostKinetic,
           .reference = "0",
           .kind = MetricKind::kBounded},
          {.metric = "kinetic energy from 15 to 20 s over that from 10 to 15 s",
           .value = value([&] { return after / std::max(before, still); }),
           .bar = 1,
           .reference = "it falls, or is below 2e-6 M g H",
           .kind = MetricKind::kRatio},
          {.metric = "volume at t = 20 s: mean height of the surface, relative",
           .value = value(surface),
           .bar = 0.005,
           .reference = "mass/(rho w), w the width; of the area that particles fill",
           .floor = Floor{0.0005, "columns end anywhere in a spacing: 0.29 dx over the root of 100, H = 45 dx: 6e-4"}}};
}

/// The tank has been tilted at t = 0; what that sets in motion is damped for five seconds.
std::vector<Verdict> MeasureTiltedRest(ParticleSystemSPH& system) {
  constexpr double kDamped = 5, kDamping = 3;  // [s], [1/s]
  system.parameters.motion_damping = kDamping;
  AdvanceTo(system, kDamped);
  system.parameters.motion_damping = 0;
  return MeasureRest(system);
}

void CloseTank(Scene& scene) {
  constexpr double kCeiling = 1.6;  // [m]
  Wall ceiling;
  ceiling.name = "ceiling";
  ceiling.fluid = FluidSide::kBelow;
  ceiling.at = ceiling.lowest = ceiling.highest = kCeiling;
  scene.base.walls.push_back(ceiling);
}

}  // namespace sph
