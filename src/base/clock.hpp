// Wall time, how much of it each phase of a step took, and processor time.
#pragma once

#include <chrono>
#include <ctime>
#include <map>
#include <string>
#include <string_view>

namespace sph {

class Stopwatch {
 public:
  /// Seconds since construction or the last Restart().
  double Seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  void Restart() { start_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Processor time of all threads of the program: what others do on the machine meanwhile is not in it.
class ProcessorStopwatch {
 public:
  double Seconds() const { return Now() - start_; }  ///< since construction

 private:
  static double Now() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double start_ = Now();
};

/// Seconds by phase name, summed over the steps.
class PhaseTimes {
 public:
  void Add(std::string_view phase, double seconds) {
    const auto found = seconds_.find(phase);
    if (found != seconds_.end()) {
      found->second += seconds;
    } else {
      seconds_.emplace(phase, seconds);
    }
  }
  const std::map<std::string, double, std::less<>>& Seconds() const { return seconds_; }
  void Clear() { seconds_.clear(); }

 private:
  std::map<std::string, double, std::less<>> seconds_;
};

/// Adds its own lifetime to a phase.
class PhaseTimer {
 public:
  PhaseTimer(PhaseTimes& times, std::string_view phase) : times_(times), phase_(phase) {}
  ~PhaseTimer() { times_.Add(phase_, watch_.Seconds()); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  PhaseTimes& times_;
  std::string_view phase_;
  Stopwatch watch_;
};

}  // namespace sph
