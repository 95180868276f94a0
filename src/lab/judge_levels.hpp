// The rules by which a metric holds: errors fall with the spacing, and none is taken for small where it changes sign.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "lab/verdict.hpp"

namespace sph {

/// A metric at one resolution.
struct Level {
  std::size_t particles = 0;
  double value = 0;
};

/// A metric, judged.
struct Judged {
  Verdict verdict;                   ///< of the case's own resolution
  std::vector<Level> levels = {};    ///< from coarse to fine
  std::optional<double> order = {};  ///< of an error, in the spacing, from the first level to the last
  bool changes_sign = false;         ///< of an error
  bool holds = false;
};

/// An *error* holds if it is within the bar at the case's own number of particles (and within the finer bar, where
/// there is one, with the most), each level is below the one before, and the order is what is demanded at least; or,
/// within the bars, if the finest level is below the floor. Where errors change sign, one of them may be small by
/// chance, and no order can be fitted through the zero: then the size of a level is the greater of its own error and
/// that of the level before, the first level has none, and the bars are held against the size of the last. So two
/// levels that differ in sign have no order, and hold if both errors are within the bar. A *bounded* metric holds if it
/// is within the bar at all levels, and no level is above the coarsest by more than 2 sqrt 2 standard deviations of
/// `seeds`, the values of the coarsest level with several seeds: two of the difference of two runs. All others hold if
/// they are within the bar.
/// @param levels  from coarse to fine, not empty, one of them of `verdict`'s value
/// @param own     the index of that one
Judged JudgeLevels(const Verdict& verdict, std::vector<Level> levels, std::size_t own, std::span<const double> seeds);

}  // namespace sph
