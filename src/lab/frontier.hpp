// What no other run beats: the least error for each run time, what it costs to reach an error, and how fast errors
// fall.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sph {

/// What a run cost, and how wrong it was.
struct Price {
  double seconds = 0;
  double error = 0;
};

/// An error is less than another if it is less than that times this: what is left is chance, and no reason to take
/// longer.
inline constexpr double kNoticed = 0.98;

/// The indices of the runs that no other run beats, by increasing time: each is noticeably less wrong than all that are
/// not longer. Runs whose time or error is not finite and > 0 are left out.
std::vector<std::size_t> Frontier(std::span<const Price> runs);

/// How long it takes to reach an error.
struct Reach {
  enum class Kind { kNever, kAtMost, kMeasured };
  Kind kind = Kind::kNever;
  double seconds = std::numeric_limits<double>::infinity();  ///< of kAtMost an upper bound

  /// "0.012", "<= 0.012" or "not reached": [s]
  std::string Text() const;
};

/// Along the frontier of the runs, whose logarithms are joined by straight lines between the one that is too wrong and
/// the next; kAtMost the quickest run if that one is good enough; kNever if none is. Precondition: error > 0.
Reach TimeToReach(std::span<const Price> runs, double error);

/// p of error ~ spacing^p, by least squares of the logarithms. Nothing with fewer than three points, or if one of them
/// is not finite and > 0.
std::optional<double> FittedOrder(std::span<const double> spacings, std::span<const double> errors);

}  // namespace sph
