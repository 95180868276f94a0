// Measured and computed series in assets/reference, each with its source in its first line.
#pragma once

#include <string>
#include <vector>

#include "base/vec2.hpp"

namespace sph {

/// The first two columns of assets/reference/`name`.csv. TroubleError if the file is not there or has a row without two
/// numbers.
std::vector<Vec2> ReadReference(const std::string& name);

}  // namespace sph
