// How far a system's density and acceleration are from the same sums in scalar double precision.
#pragma once

#include "sph/particle_system_sph.hpp"

namespace sph {

/// Greatest difference over greatest value. In water nearly at rest that is severe on accelerations: P = k
/// ((rho/rho0)^7
/// - 1) is a hundredth of rho c^2 or less, and what P of one side leaves of that of the other a part of g.
struct FieldErrors {
  double density = 0;
  double acceleration = 0;
};

/// Of about `samples` particles of solver paper, evenly spread over its order. The twin has its own search for
/// neighbours and the kernels of kernels.hpp, and nothing of what makes the system fast. Density and accelerations must
/// be those of the current positions, without walls: see ParticleSystem::ComputeFields.
/// Precondition: no motion damping in the accelerations, that is leapfrog integration.
FieldErrors ErrorsAgainstScalarTwin(const ParticleSystemSPH& system, std::size_t samples = 1000);

}  // namespace sph
