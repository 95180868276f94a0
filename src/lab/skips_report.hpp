// What leaving out saves, as CSV and as a table for people.
#pragma once

#include <span>
#include <string>

#include "lab/skips.hpp"

namespace sph {

/// The first line has the column names.
std::string SkipsAsCsv(std::span<const SkipResult> results);

/// What the table's rows are, and a row: three lines.
std::string SkipsTableHead();
std::string SkipsTableRow(const SkipResult& result);

}  // namespace sph
