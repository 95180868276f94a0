// How long a time step may be, and what says so.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sph {

/// What a longer step would harm.
enum class LimitKind {
  kSwinging,  ///< stability of something that swings
  kDecaying,  ///< stability of something that decays
  kAccuracy,  ///< nothing grows without bound
};

/// One limit: a step of `seconds` would be just stable, or just good enough.
struct StepLimit {
  std::string what;
  double seconds = 0;  ///< infinite if the scene has nothing that limits the step in this way
  LimitKind of = LimitKind::kSwinging;
};

/// What the program allows of these steps.
inline constexpr double kStepSafety = 0.8;

/// The step that keeps all limits at once, times kStepSafety [s]. Leapfrog is stable for omega dt < 2; where several
/// springs act on a particle their omega^2 add up. What swings with omega and decays, by an explicit term, at the rate
/// d is just stable where omega^2 dt^2/4 + d dt/2 = 1: there the amplification is -1. So the sum over the limits L is
/// dt^2/L^2 for what swings and dt/L for what decays. Accuracy has no part in that sum.
inline double LargestStep(const std::vector<StepLimit>& limits) {
  double swings = 0, decays = 0, accurate = std::numeric_limits<double>::infinity();
  for (const StepLimit& limit : limits) {
    switch (limit.of) {
      case LimitKind::kSwinging:
        swings += 1 / (limit.seconds * limit.seconds);
        break;
      case LimitKind::kDecaying:
        decays += 1 / limit.seconds;
        break;
      case LimitKind::kAccuracy:
        accurate = std::min(accurate, limit.seconds);
        break;
    }
  }
  return kStepSafety * std::min(accurate, 2 / (decays + std::sqrt(decays * decays + 4 * swings)));
}

}  // namespace sph
