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
Errors ErrorsNow(ParticleSystemSPH& system) {
  if (system.Trouble()) return {};
  system.ComputeFields();
  const Particles& p = system.State();
  const double nu = system.parameters_sph.viscosity / ReferenceDensity(system.parameters_sph.equation_of_state);
  const double side = system.parameters_sph.periods.box.Width();
  const double decay = std::exp(-8 * std::numbers::pi * std::numbers::pi * nu / (side * side) * system.Time());
  const std::vector<double> pressure = system.Pressure();
  double mean_pressure = 0;
  for (const double value : pressure) mean_pressure += value / static_cast<double>(p.Size());
  double velocity_error = 0, speed_sum = 0, pressure_error = 0, greatest_pressure = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const FlowAtPoint start = system.FlowAt(p.Position(i));
    const double speed = decay * Length(start.velocity);
    const double exact_pressure = decay * decay * start.pressure;
    velocity_error += std::abs(Length(p.Velocity(i)) - speed);
    speed_sum += speed;
    pressure_error += std::abs(pressure[i] - mean_pressure - exact_pressure);
    greatest_pressure = std::max(greatest_pressure, std::abs(exact_pressure));
  }
  return {velocity_error / speed_sum, pressure_error / (static_cast<double>(p.Size()) * greatest_pressure)};
}

}  // namespace

std::vector<Verdict> MeasureTaylorGreen(ParticleSystemSPH& system) {
  AdvanceTo(system, 0.5);
  const Errors half = ErrorsNow(system);
  AdvanceTo(system, 1);
  const Errors whole = ErrorsNow(system);
  return {
      {"L1 of speed at t = 1 s", whole.velocity, 0.005, "exact; delta-SPH with shifting 0.0071, PySPH's EDAC 0.0090"},
      {"L1 of pressure at t = 0.5 s", half.pressure, 0.006, "exact; corrected gradients 0.006, PySPH's EDAC 0.37"}};
}

}  // namespace sph
