// What must hold for a scene as a whole, which no single key can see.
#pragma once

#include <string>

#include "scenes/scene.hpp"

namespace sph {

/// UsageError, naming `source` and what is missing or contradicts, unless the fluid has a region inside the walls and
/// an equation of state, and forces, reference and controls name things that are there.
void CheckWhole(const Scene& scene, const std::string& source);

}  // namespace sph
