// What must hold for a scene as a whole, which no single key can see.
#pragma once

#include <string>

#include "scenes/scene.hpp"

namespace sph {

/// UsageError, naming `source` and what is missing or contradicts, unless the fluid has a region inside the walls and
/// an equation of state: what the method's rules go by.
void CheckFluid(const Scene& scene, const std::string& source);

/// The same, and of forces, reference and controls, which must name things that are there.
void CheckWhole(const Scene& scene, const std::string& source);

}  // namespace sph
