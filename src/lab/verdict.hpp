// What a run is judged by: metrics of several kinds, each with the rule that goes with it.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace sph {

/// What JudgeLevels demands of a metric.
enum class MetricKind {
  kError,      ///< falls with the spacing, as the scheme promises
  kBounded,    ///< within its bar at every resolution, without growing as the spacing falls
  kRatio,      ///< of two errors or states, from one case
  kInvariant,  ///< what the scheme keeps but for round-off
  kBand,       ///< the reference is uncertain itself: another method's result, an experiment
  kPrice,      ///< a run time
};

/// "error", "bounded", "ratio", "invariant", "band", "price"
const char* NameOf(MetricKind kind);

/// An error as a part of the quantity's own scale.
struct RelativeError {
  std::string metric;
  double value = 0;
};

/// How an error falls with the spacing.
struct Promise {
  double order = 1;  ///< the scheme's
  const char* why = "the sums are cut off at the free surface";
  double least = 0.5 * order;  ///< that is demanded
};

/// Below which an error need not fall: known before the run, and a tenth of the bar at most.
struct Floor {
  double value = 0;
  const char* why = "";
};

/// One metric of one run.
struct Verdict {
  std::string metric;                          ///< with its unit, or relative
  double value = 0;                            ///< of an error that is too large or too small: with its sign
  double bar = 0;                              ///< of its size, at the case's own resolution
  std::string reference;                       ///< what is exact, and what others reach
  std::optional<RelativeError> relative = {};  ///< the same, where `value` has a unit
  MetricKind kind = MetricKind::kError;
  Promise promise = {};                  ///< of an error
  std::optional<Floor> floor = {};       ///< of an error
  std::optional<double> finer_bar = {};  ///< of its size with more particles, where less is demanded of few

  bool WithinBar() const { return std::abs(value) <= bar; }
};

/// A metric against a reference that is uncertain itself.
inline Verdict AgainstBand(std::string metric, double value, double bar, std::string reference) {
  return {.metric = std::move(metric),
          .value = value,
          .bar = bar,
          .reference = std::move(reference),
          .kind = MetricKind::kBand};
}

/// The value of a metric of a run that broke down: no bar holds it.
inline constexpr double kBroken = std::numeric_limits<double>::infinity();

}  // namespace sph
