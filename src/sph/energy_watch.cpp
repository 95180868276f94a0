#include "sph/energy_watch.hpp"

#include <algorithm>
#include <cmath>

#include "particles/diagnostics.hpp"

namespace sph {
namespace {

/// K depth^2/2 of every particle in a penalty wall [J/m].
double EnergyOfWalls(const ParticleSystem& system) {
  const Parameters& parameters = system.parameters;
  if (parameters.wall.kind != WallKind::kPenalty) return 0;
  const Particles& p = system.State();
  double sum = 0;
  for (const Wall& wall : parameters.walls) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double depth = std::max(0.0, wall.Depth(p.Position(i)));
      sum += 0.5 * p.mass[i] * parameters.wall.stiffness * depth * depth;
    }
  }
  return sum;
}

bool IsKnown(const ParticleSystemSPH& system) {
  const Parameters& parameters = system.parameters;
  const Periods& periods = system.parameters_sph.periods;
  const Vec2 g = parameters.gravity;
  const bool driven = (periods.in_x && g.x != 0) || (periods.in_y && g.y != 0) ||
                      std::ranges::any_of(parameters.walls, [](const Wall& wall) { return wall.tangential.Any(); });
  const ParametersSPH& sph = system.parameters_sph;
  return !driven && !sph.mueller_published && sph.delta.surface_tension == 0;
}

}  // namespace

EnergyWatch::Reference EnergyWatch::Measure(const ParticleSystemSPH& system) {
  const Diagnostics d = Diagnose(system);
  const Vec2 g = system.parameters.gravity;
  const Particles& p = system.State();
  double mass = 0;
  for (const double m : p.mass) mass += m;
  const Vec2 lowest{g.x > 0 ? d.bounds.x1 : d.bounds.x0, g.y > 0 ? d.bounds.y1 : d.bounds.y0};
  const double walls = EnergyOfWalls(system);
  return {
      system.Time(), d.kinetic_energy + d.potential_energy + d.internal_energy + walls,
      d.kinetic_energy + std::abs(d.potential_energy + mass * Dot(g, lowest)) + std::abs(d.internal_energy) + walls};
}

std::string EnergyWatch::Look(const ParticleSystemSPH& system) {
  if (warned_ || system.Steps() < next_look_ || system.Trouble() || !IsKnown(system)) return {};
  next_look_ = system.Steps() + kStepsApart;
  const Reference now = Measure(system);
  const bool walls_move =
      std::ranges::any_of(system.parameters.walls, [](const Wall& wall) { return wall.velocity != 0; });
  if (!reference_ || walls_move) reference_ = now;
  const double gain = now.energy - reference_->energy;
  if (!(gain > kTolerance * reference_->to_lose)) return {};
  warned_ = true;
  return fmt::format(
      "the energy of the fluid has grown from {:.4g} J/m at t = {:.4g} s to {:.4g} J/m, and nothing put it in: the "
      "forces make it, and the run is not to be believed; more viscosity takes it out",
      reference_->energy, reference_->time, now.energy);
}

}  // namespace sph
