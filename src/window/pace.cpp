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
      due_ = std::min(due_, debt_ * session.speed);
      break;
    }
  }
  if (session.System().Trouble()) due_ = 0;
  return steps;
}

std::chrono::duration<double> Pace::Wait(const Session& session) const {
  using Seconds = std::chrono::duration<double>;
  if (session.System().Trouble() || (session.paused && session.single_steps == 0)) return std::chrono::hours(1);
  const Seconds until_due((session.System().parameters.time_step - due_) / session.speed);
  constexpr Seconds kLeast(0.001);  // a thread woken more often than that does little else
  return until_due <= Seconds(0) ? Seconds(0) : std::max(until_due, kLeast);
}

}  // namespace sph
