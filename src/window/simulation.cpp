#include "window/simulation.hpp"

#include <sys/resource.h>

#include <utility>

#include "window/controls.hpp"

namespace sph {
namespace {

constexpr double kBudget = 0.004;  // [s] of steps in a row, so that keys do not wait longer if steps are short
constexpr double kDebt = 0.1;      // [s] of wall time that is made up for when the machine was busy with something else

/// [s] Where a frame takes longer, the processors draw it, and steps made beside it would only make both longer: a key
/// would then wait for a long frame, the rest of a long step and the frame that shows what it does. In turns it waits
/// for a frame or a step.
constexpr double kLongFrame = 0.010;

/// The calling thread, and those that it starts, leave the processors to whoever else wants them now: to the thread
/// that draws and to OpenGL's own. It draws part of the time only, so the simulation is slowed down, not stopped.
void LetOthersGoFirst() {
  constexpr int kNicer = 10;
  const int niceness = getpriority(PRIO_PROCESS, 0);  // on Linux that of this thread
  setpriority(PRIO_PROCESS, 0, niceness + kNicer);    // if it is refused, nothing is lost but smoothness
}

}  // namespace

Simulation::Simulation(const SceneRequest& request, std::function<void()> on_news)
    : on_news_(std::move(on_news)), session_(request), pace_(kBudget, kDebt) {
  Publish();
  moments_.Take();
}

Simulation::~Simulation() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Simulation::Start() {
  thread_ = std::thread([this] {
    try {
      Run();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
    on_news_();
  });
}

void Simulation::Post(KeyEvent event) {
  {
    const std::lock_guard lock(mutex_);
    posted_.push_back(std::move(event));
  }
  changed_.notify_one();
}

void Simulation::AskForNews() {
  {
    const std::lock_guard lock(mutex_);
    asked_ = true;
  }
  changed_.notify_one();
}

void Simulation::NoteShown(double seconds) {
  ++frames_;
  {
    const std::lock_guard lock(mutex_);
    shown_ = Now().number;
    take_turns_ = seconds > kLongFrame;
  }
  changed_.notify_one();
}

bool Simulation::Take() {
  {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  }
  return moments_.Take();
}

void Simulation::Run() {
  LetOthersGoFirst();
  last_advance_ = clock_.Seconds();
  while (WaitForWork()) {
    const bool stood = session_.paused || session_.System().Trouble();
    Act();
    const double now = clock_.Seconds();
    const int steps = pace_.Advance(session_, stood ? 0 : now - last_advance_);  // no pause is made up for
    last_advance_ = now;
    meter_.CountSteps(steps);
    has_changed_ = has_changed_ || steps > 0;
  }
}

/// Returns when a key was pressed or a step is due, the keys in events_; has published what was asked for.
/// @return whether to go on
bool Simulation::WaitForWork() {
  std::unique_lock lock(mutex_);
  const auto wanted = [this] { return asked_ && has_changed_; };
  const std::chrono::duration<double> since(clock_.Seconds() - last_advance_);
  const auto due = std::chrono::steady_clock::now() + (pace_.Wait(session_) - since);
  for (;;) {
    if (posted_.empty() && wanted()) {
      lock.unlock();
      Publish();
      lock.lock();
      if (take_turns_) WaitUntilShown(lock);
    }
    const bool woken = changed_.wait_until(lock, due, [&] { return stopped_ || !posted_.empty() || wanted(); });
    if (stopped_) return false;
    if (woken && posted_.empty()) continue;
    events_.clear();
    std::swap(events_, posted_);
    return true;
  }
}

/// Presses and releases the keys, and says at once what came of it: the next step may take long.
void Simulation::Act() {
  bool pressed = false;
  for (const KeyEvent& event : events_) {
    if (!event.down) {
      ReleaseKey(session_, event.key);
      continue;
    }
    PressKey(session_, event.key);
    message_ = std::exchange(session_.message, {});
    ++acted_on_;
    if (std::exchange(session_.save_requested, false)) ++saves_;
    pressed = true;
  }
  if (!pressed) return;
  Publish();
  std::unique_lock lock(mutex_);
  WaitUntilShown(lock);
}

/// Leaves the processors to the frame that shows what was published last.
void Simulation::WaitUntilShown(std::unique_lock<std::mutex>& lock) {
  constexpr std::chrono::milliseconds kPatience(50);  // a display that waits, or is not to be seen, holds nothing up
  changed_.wait_for(lock, kPatience, [this] { return stopped_ || shown_ >= published_; });
}

void Simulation::Publish() {
  {
    const std::lock_guard lock(mutex_);
    asked_ = false;
  }
  if (std::exchange(system_, &session_.System()) != &session_.System()) ++scene_number_;
  for (int frames = frames_.exchange(0); frames > 0; --frames) meter_.CountFrame();
  Moment& moment = moments_.Fill();
  Note(session_, meter_.Read(clock_.Seconds(), session_.System().Time()), moment);
  moment.number = ++published_;
  moment.scene_number = scene_number_;
  moment.presses = acted_on_;
  moment.message = message_;
  moment.saves = saves_;
  moment.quit = session_.quit_requested;
  has_changed_ = false;
  moments_.Publish();
  on_news_();
}

}  // namespace sph
