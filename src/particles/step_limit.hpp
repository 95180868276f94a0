// How long a time step may be, and what says so.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace sph {

/// One limit: a step of `seconds` would be just stable.
struct StepLimit {
  std::string what;
  double seconds = 0;    ///< infinite if the scene has nothing that limits the step in this way
  bool damping = false;  ///< of something that decays, not of something that swings
};

/// What the program allows of the steps that would be just stable.
inline constexpr double kStepSafety = 0.8;

/// The step that keeps all limits at once, times kStepSafety [s]. Leapfrog is stable for omega dt < 2; where several
/// springs act on a particle their omega^2 add up. What swings with omega and decays, by an explicit term, at the rate
/// d is just stable where omega^2 dt^2/4 + d dt/2 = 1: there the amplification is -1. So the sum over the limits L is
/// dt^2/L^2 for what swings and dt/L for what decays.
inline double LargestStep(const std::vector<StepLimit>& limits) {
  double swings = 0, decays = 0;
  for (const StepLimit& limit : limits) {
    (limit.damping ? decays : swings) += 1 / (limit.damping ? limit.seconds : limit.seconds * limit.seconds);
  }
  return kStepSafety * 2 / (decays + std::sqrt(decays * decays + 4 * swings));
}

}  // namespace sph
