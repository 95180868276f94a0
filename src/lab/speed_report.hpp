// The measured run times as CSV, as a table for people, and as a plot.
#pragma once

#include <span>
#include <string>

#include "lab/plot.hpp"
#include "lab/speed.hpp"

namespace sph {

/// The first line has the column names with units.
std::string SpeedAsCsv(std::span<const SpeedResult> results);

/// The names of the table's columns, and a row of it; both end with a newline.
std::string SpeedTableHead();
std::string SpeedTableRow(const SpeedResult& result);

/// What the limit is made of, in a few lines.
std::string DescribeLimit(const RatesOfThreads& rates);

/// Million particle-steps per second of the tank against N: on one thread every instruction set in float and the best
/// in double, the best in float on two threads, and the limits of one thread.
Plot SpeedPlot(std::span<const SpeedResult> results);

/// "float", "double"
std::string_view NameOf(Precision precision);

}  // namespace sph
