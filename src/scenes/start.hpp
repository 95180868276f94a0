// Starts that take a run of their own: a fluid that settles before the clock starts, and even but random packing.
#pragma once

#include <vector>

#include "scenes/scene.hpp"

namespace sph {

/// Where the particles of the scene start, in the order in which they are placed; empty where `base` alone says it.
/// TroubleError if the fluid breaks down while it settles.
std::vector<StartingParticle> FindStart(const Scene& scene, const Parameters& base);

}  // namespace sph
