// A session that runs in a thread of its own, as fast as the clock, while the window draws what it last was.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/clock.hpp"
#include "base/double_buffer.hpp"
#include "window/moment.hpp"
#include "window/pace.hpp"
#include "window/rate_meter.hpp"
#include "window/session.hpp"

namespace sph {

/// Everything here is for the thread that draws, but for what `on_news` does.
class Simulation {
 public:
  /// Loads the scene and notes its first moment; it does not run yet. UsageError or TroubleError as the session's.
  /// @param on_news  called by the simulation's thread whenever there is something new to take
  Simulation(const SceneRequest& request, std::function<void()> on_news);
  /// Ends the thread after the step that it is in.
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// From now on simulated time goes with the clock.
  void Start();
  /// Keys act at the end of the step that is being made, and what they did is news.
  void Press(const std::string& key) {
    ++presses_;
    Post({key, true});
  }
  void Release(const std::string& key) { Post({key, false}); }
  /// The next change is news; without this, only what keys did is.
  void AskForNews();

  /// Takes what is new. @return whether something is; throws what the simulation's thread has failed with
  bool Take();
  /// The moment that was taken last.
  const Moment& Now() const { return moments_.Front(); }
  /// Has that moment seen all keys pressed so far?
  bool IsUpToDate() const { return Now().presses == presses_; }
  /// The moment that was taken last has been shown; drawing it took so long.
  void NoteShown(double seconds);

 private:
  struct KeyEvent {
    std::string key;
    bool down = true;
  };

  void Post(KeyEvent event);
  void Run();
  bool WaitForWork();
  void Act();
  void WaitUntilShown(std::unique_lock<std::mutex>& lock);
  void Publish();

  std::function<void()> on_news_;
  DoubleBuffer<Moment> moments_;
  long presses_ = 0;             // posted
  std::atomic<int> frames_ = 0;  // shown since they were last counted

  // Given to the thread.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<KeyEvent> posted_;
  bool asked_ = false;
  long shown_ = 0;           // number of the moment shown last
  bool take_turns_ = false;  // steps are made between frames, not beside them
  bool stopped_ = false;
  std::exception_ptr failure_;  // by the thread

  // The thread's, once it runs.
  Session session_;
  Pace pace_;
  RateMeter meter_;
  Stopwatch clock_;
  double last_advance_ = 0;  // [s] on clock_
  std::vector<KeyEvent> events_;
  const ParticleSystemSPH* system_ = nullptr;  // of the last moment, to know another scene by
  long scene_number_ = 0;
  long published_ = 0;  // moments
  long acted_on_ = 0;   // presses
  std::string message_;
  long saves_ = 0;
  bool has_changed_ = false;  // since the last moment

  std::thread thread_;
};

}  // namespace sph
