// Measured and computed series in assets/reference, each with its source in its first line.
#pragma once

#include <string>
#include <vector>

#include "base/vec2.hpp"

namespace sph {

/// The first columns of assets/reference/`name`.csv, row by row. TroubleError if the file is not there or has a row
/// without so many numbers.
std::vector<std::vector<double>> ReadReferenceRows(const std::string& name, std::size_t columns);

/// The first two columns of assets/reference/`name`.csv. TroubleError as above.
std::vector<Vec2> ReadReference(const std::string& name);

}  // namespace sph
