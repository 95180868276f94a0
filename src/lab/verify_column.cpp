// What must not grow as the water column breaks, however many particles there are: noise at the wall, energy, the
// spread of densities, pairs.
#include <algorithm>
#include <cmath>

#include "lab/fill_gauges.hpp"
#include "lab/verification.hpp"
#include "lab/wall_probe.hpp"
#include "particles/diagnostics.hpp"

namespace sph {
namespace {

/// A mean and what departs from it, of a signal that lasts.
class Fluctuation {
 public:
  void Add(double value, double seconds) {
    time_ += seconds;
    sum_ += seconds * value;
    squares_ += seconds * value * value;
  }
  double Rms() const {
    const double mean = sum_ / time_;
    return std::sqrt(std::max(0.0, squares_ / time_ - mean * mean));
  }

 private:
  double time_ = 0, sum_ = 0, squares_ = 0;
};

/// The greatest rise of a signal above what it was before.
class Rise {
 public:
  void Add(double value) {
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value - least_);
  }
  double Greatest() const { return greatest_; }

 private:
  double least_ = kBroken, greatest_ = 0;
};

double EnergyNow(ParticleSystemSPH& system) {
  system.ComputeFields();
  const Diagnostics d = Diagnose(system);
  return d.kinetic_energy + d.potential_energy + d.internal_energy;
}

Verdict Bounded(const std::string& metric, double value, double bar, const std::string& reference) {
  return {.metric = metric, .value = value, .bar = bar, .reference = reference, .kind = MetricKind::kBounded};
}

}  // namespace

std::vector<Verdict> MeasureColumnNoise(ParticleSystemSPH& system) {
  constexpr double kFrom = 1, kTo = 1.5, kApart = 0.01;  // [s]
  const Box column = system.parameters.fluid.region.box;
  const double rho0 = ReferenceDensity(system.parameters_sph.equation_of_state);
  const Vec2 gauge{column.x0, column.y0 + 0.2 * column.Width()};
  const double start = EnergyNow(system);
  Fluctuation pressure;
  Rise energy;
  energy.Add(start);
  for (double look = kApart; look < kTo + 0.5 * kApart && !system.Trouble(); look += kApart) {
    while (system.Time() < look && !system.Trouble()) {
      system.Step();
      if (system.Time() > kFrom) pressure.Add(PressureAtWall(system, gauge), system.parameters.time_step);
    }
    energy.Add(EnergyNow(system));
  }
  const bool broken = system.Trouble().has_value();
  const auto value = [&](double measured) { return broken ? kBroken : measured; };
  const std::vector<double> density = system.Density();
  const auto [least, greatest] = std::ranges::minmax(density);
  const double weight = -rho0 * system.parameters.gravity.y * column.Height();
  return {Bounded("noise of pressure at the wall, RMS over rho g 2a", value(pressure.Rms() / weight), 0.35,
                  "y = 0.2 a, about the mean, t = 1 to 1.5 s; 0.24 without shifting"),
          Bounded("energy, greatest rise over the start's", value(energy.Greatest() / start), 0.001, "it never rises"),
          Bounded("density, greatest less least over rho0, t = 1.5 s", value((greatest - least) / rho0), 0.01,
                  "no more than the flow's pressures make"),
          Bounded("share of paired particles at t = 1.5 s",
                  value(PairedShare(system.State(), 0.5 * system.InitialSpacing())), 0.015, "none")};
}

}  // namespace sph
