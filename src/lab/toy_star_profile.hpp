// The paper's Figure 3: density against radius in a toy star, exact and as the particles have it.
#pragma once

#include "lab/plot.hpp"
#include "particles/particle_system.hpp"
#include "sph/toy_star.hpp"

namespace sph {

/// Eq. 22 as a curve up to r = R, every particle as a point, and the mean square error of these [CompareDensity] in the
/// legend. Precondition: the system's fields are those of its positions [ParticleSystem::ComputeFields].
Plot ToyStarProfile(const ParticleSystem& system, const ToyStar& star);

}  // namespace sph
