// Sums over the particles that say whether a run can be trusted: energies, momenta, extent, leaks, a hash of the state.
#pragma once

#include <cstdint>

#include "particles/particle_system.hpp"

namespace sph {

struct Range {
  double min = 0;
  double mean = 0;
  double max = 0;
};

struct Diagnostics {
  double kinetic_energy = 0;     ///< [J/m]
  double potential_energy = 0;   ///< of gravity and central force, 0 at the origin [J/m]
  double internal_energy = 0;    ///< [J/m]
  Vec2 momentum;                 ///< [kg/s]
  double angular_momentum = 0;   ///< about the origin [kg m/s]
  Vec2 centre_of_mass;           ///< [m]
  double max_speed = 0;          ///< [m/s]
  Range density;                 ///< [kg/m^3]
  Box bounds;                    ///< of the particles [m]
  std::size_t outside = 0;       ///< particles beyond a wall by more than one spacing
  double deepest = 0;            ///< deepest penetration of a wall since the start, in spacings
  std::uint64_t state_hash = 0;  ///< of positions and velocities in the order of creation, and of the time
};

/// One pass over the state; sums in the order of creation, so that equal states give equal bits.
Diagnostics Diagnose(const ParticleSystem& system);

}  // namespace sph
