// Fluid that could not start where, or as, the scene has it is refused.
#pragma once

#include <string>

#include "scenes/scene.hpp"

namespace sph {

/// UsageError, `source` being where the scene is from, if a particle would start behind a wall or at the place of
/// another one's periodic twin, if positions are too far from the origin for the spacing, or if the pressure to start
/// with carries the fluid against a gravity that no wall holds it against. The lattice must not be too fine.
void CheckPlacement(const Scene& scene, const std::string& source);

}  // namespace sph
