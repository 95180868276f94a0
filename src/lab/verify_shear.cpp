// A wave of shear across the axes of a box that repeats.
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"

namespace sph {

/// u(t) = u(0) exp(-nu |k|^2 t), k = 2 pi/L (1, 1): (u.grad) u = 0, and the Navier-Stokes equations are linear.
std::vector<Verdict> MeasureShearWave(ParticleSystemSPH& system) {
  AdvanceTo(system, 1);
  const double wave = 2 * std::numbers::pi / system.parameters_sph.periods.box.Width();
  const double nu = system.parameters_sph.viscosity / ReferenceDensity(system.parameters_sph.equation_of_state);
  const double decay = std::exp(-2 * nu * wave * wave * system.Time());
  const Particles& p = system.State();
  double norm = 0, errors = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 exact = decay * system.FlowAt(p.Position(i)).velocity;
    const Vec2 error = p.Velocity(i) - exact;
    norm += Dot(exact, exact);
    errors += Dot(error, error);
  }
  return {{.metric = "L2 of velocity at t = 1 s, relative",
           .value = system.Trouble() ? kBroken : std::sqrt(errors / norm),
           .bar = 0.005,
           .reference = "exact",
           .promise = {2, "sums over a whole support and a centred step"}}};
}

}  // namespace sph
