// How long a time step may be, and what says so.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace sph {

/// One limit: a step of `seconds` would be just stable.
struct StepLimit {
  std::string what;
  double seconds = 0;  ///< infinite if the scene has nothing that limits the step in this way
};

/// What the program allows of the steps that would be just stable.
inline constexpr double kStepSafety = 0.8;

/// The step that keeps all limits at once, times kStepSafety [s]. Leapfrog is stable for omega dt < 2; where several
/// springs act on a particle their omega^2 add up, so 1/dt^2 is the sum of the limits' 1/dt^2.
inline double LargestStep(const std::vector<StepLimit>& limits) {
  double sum = 0;
  for (const StepLimit& limit : limits) sum += 1 / (limit.seconds * limit.seconds);
  return kStepSafety / std::sqrt(sum);
}

}  // namespace sph
