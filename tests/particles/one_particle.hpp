// A system of a single particle, whose motion can be worked out by hand.
#pragma once

#include "particles/particle_system.hpp"

namespace sph {

/// Parameters of one particle of mass 1 at `position` with `velocity`, without forces and walls.
inline Parameters OneParticle(Vec2 position, Vec2 velocity, double time_step) {
  Parameters one;
  one.fluid.particles = 1;
  one.fluid.region.box = {position.x - 0.5, position.y - 0.5, position.x + 0.5, position.y + 0.5};
  one.fluid.arrange = Arrangement::kLattice;  // a square of side 1 with a site in its middle
  one.fluid.velocity = velocity;
  one.particle_mass = 1;
  one.time_step = time_step;
  return one;
}

/// The same under the other ways to integrate.
inline constexpr Integration kAllIntegrations[] = {Integration::kLeapFrog, Integration::kLeapFrogPublished,
                                                   Integration::kSymplecticEuler};

/// A system at its start that runs for `time` [s], a multiple of the step.
inline void RunFor(ParticleSystem& system, double time) {
  const long steps = std::lround(time / system.parameters.time_step);
  for (long k = 0; k < steps; ++k) system.Step();
}

}  // namespace sph
