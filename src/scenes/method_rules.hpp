// What a scene does not say of its method follows from the scene, by rules: see assets/guide/method.md.
#pragma once

#include <set>
#include <string>

#include "scenes/scene.hpp"

namespace sph {

/// Keys that somebody gave, dotted.
using GivenKeys = std::set<std::string, std::less<>>;

/// Whether walls and periods leave no room but what the liquid fills, so that it has no surface.
bool IsClosed(const Scene& scene);

/// Sets every key of [method] that has a rule and is not among those given. The fluid's region and the walls are known.
void CompleteMethod(Scene& scene, const GivenKeys& given);

}  // namespace sph
