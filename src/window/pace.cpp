#include "window/pace.hpp"

#include <algorithm>

namespace sph {

int Pace::Advance(Session& session, double elapsed) {
  int steps = 0;
  if (session.paused) {
    due_ = 0;
    while (session.StepUnlessPaused()) ++steps;
    return steps;
  }
  due_ += elapsed * session.speed;
  const Stopwatch watch;
  while (due_ >= session.System().parameters.time_step && !session.System().Trouble()) {
    session.Step();
    ++steps;
    due_ -= session.System().parameters.time_step;
    const double step_seconds = watch.Seconds() / steps;
    if (watch.Seconds() + step_seconds > budget_) {  // one more would be too much
      due_ = std::min(due_, 0.0);
      break;
    }
  }
  if (session.System().Trouble()) due_ = 0;
  return steps;
}

}  // namespace sph
