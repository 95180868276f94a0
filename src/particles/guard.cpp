#include "particles/guard.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

Guard::Guard(ParticleSystem& system, int retries) : system_(system), retries_(retries) { Mark(); }

void Guard::Mark() {
  if (system_.Trouble()) return;
  Note(noted_[0]);
  noted_[1] = noted_[0];
  next_note_ = system_.Steps() + kStepsApart;
}

void Guard::Reset() {
  retreats_ = 0;
  last_retreat_.clear();
  Mark();
}

void Guard::Step() {
  if (system_.Trouble()) return;
  system_.Step();
  if (system_.Trouble()) {
    if (retreats_ < retries_) {
      Retreat();
    } else {
      GiveUp();
    }
  } else if (system_.Steps() >= next_note_) {
    std::swap(noted_[0], noted_[1]);
    Note(noted_[1]);
    next_note_ = system_.Steps() + kStepsApart;
  }
}

void Guard::ComputeFields() {
  if (system_.Trouble()) return;
  system_.ComputeFields();
  if (system_.Trouble()) GiveUp();
}

/// What is shown, reported or saved of a run that broke down is a state that was in order.
void Guard::GiveUp() {
  Instability trouble = *system_.Trouble();
  trouble.advice = Advice();
  GoBack();
  system_.StopWith(trouble);
}

void Guard::GoBack() {
  if (noted_[0].state.empty()) return;  // not even the start was in order
  Archive archive = Archive::Reader(noted_[0].state, Archive::Extent::kPhysics);
  system_.Transfer(archive);
  system_.ComputeFields();  // a view wants those of this state
}

void Guard::Retreat() {
  const std::string what = system_.Trouble()->Message();
  GoBack();
  Parameters& parameters = system_.parameters;
  (parameters.adaptive_step ? parameters.caution : parameters.time_step) *= 0.5;
  ++retreats_;
  last_retreat_ = fmt::format("{}; back to t = {:.6g} s with half the step, retry {} of {}", what, system_.Time(),
                              retreats_, retries_);
  Mark();
}

void Guard::Note(Noted& noted) {
  noted.state.clear();
  Archive archive = Archive::Writer(noted.state, Archive::Extent::kPhysics);
  system_.Transfer(archive);
  const std::vector<StepLimit> limits = system_.StepLimits();
  noted.longest_step = LargestStep(limits);
  noted.limit = std::ranges::min_element(limits, {}, &StepLimit::seconds)->what;
}

std::string Guard::Advice() const {
  const Noted& good = noted_[0];
  if (!std::isfinite(good.longest_step)) return {};
  const double step = system_.parameters.time_step;
  if (step > good.longest_step) {
    return fmt::format("before it broke down, dt <= {:.2g} s would have held: {}", good.longest_step, good.limit);
  }
  return fmt::format(
      "before it broke down, dt <= {:.2g} s should have held ({}), and the step was {:.2g} s: look for a "
      "force or a speed that came in suddenly",
      good.longest_step, good.limit, step);
}

void Guard::Transfer(Archive& archive) {
  archive(retreats_, last_retreat_, next_note_);
  for (Noted& noted : noted_) archive(noted.state, noted.longest_step, noted.limit);
}

}  // namespace sph
