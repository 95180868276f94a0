// Taylor-Green vortices against the exact solution of the Navier-Stokes equations.
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"

namespace sph {
namespace {

struct Errors {
  double velocity = kBroken;  // mean ||v| - |v_exact|| over mean |v_exact|
  double pressure = kBroken;  // mean |p - mean p - p_exact| over greatest |p_exact|
};

/// [The measures of PySPH's taylor_green.py.]
Errors ErrorsOf(const ParticleSystemSPH& flow, const FlowSnapshot& snapshot) {
  const Particles& p = snapshot.particles;
  const double nu = flow.parameters_sph.viscosity / ReferenceDensity(flow.parameters_sph.equation_of_state);
  const double side = flow.parameters_sph.periods.box.Width();
  const double decay = std::exp(-8 * std::numbers::pi * std::numbers::pi * nu / (side * side) * snapshot.time);
  double mean_pressure = 0;
  for (const double value : snapshot.pressure) mean_pressure += value / static_cast<double>(p.Size());
  double velocity_error = 0, speed_sum = 0, pressure_error = 0, greatest_pressure = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const FlowAtPoint start = flow.FlowAt(p.Position(i));
    const double speed = decay * Length(start.velocity);
    const double exact_pressure = decay * decay * start.pressure;
    velocity_error += std::abs(Length(p.Velocity(i)) - speed);
    speed_sum += speed;
    pressure_error += std::abs(snapshot.pressure[i] - mean_pressure - exact_pressure);
    greatest_pressure = std::max(greatest_pressure, std::abs(exact_pressure));
  }
  return {velocity_error / speed_sum, pressure_error / (static_cast<double>(p.Size()) * greatest_pressure)};
}

std::vector<double> Times(const ParticleSystemSPH&) { return {0.5, 1}; }

std::vector<Verdict> JudgeTaylorGreen(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots) {
  const Errors half = snapshots.empty() ? Errors{} : ErrorsOf(flow, snapshots[0]);
  const Errors whole = snapshots.empty() ? Errors{} : ErrorsOf(flow, snapshots[1]);
  return {{.metric = "L1 of speed at t = 1 s",
           .value = whole.velocity,
           .bar = 0.003,
           .reference = "exact; delta-SPH with shifting 0.0071, PySPH's EDAC 0.0090",
           .promise = {2, "sums over whole supports and a centred step", 1.7}},
          {.metric = "L1 of pressure at t = 0.5 s",
           .value = half.pressure,
           .bar = 0.006,
           .reference = "exact; corrected gradients 0.006, PySPH's EDAC 0.37",
           .promise = {1, "sums over particles in disorder", 1}}};
}

}  // namespace

const Judgement kTaylorGreen{&Times, &JudgeTaylorGreen};

std::vector<Verdict> MeasureTaylorGreen(ParticleSystemSPH& system) { return Judge(kTaylorGreen, system); }

}  // namespace sph
