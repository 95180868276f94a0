// Times of phases: sums by name, whoever adds them; processor time does not go on while one waits.
#include "base/clock.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace sph {
namespace {

TEST(PhaseTimes, SumsWhatIsAddedUnderTheSameName) {
  PhaseTimes times;
  times.Add("grid", 0.25);
  times.Add("density", 1.0);
  times.Add("grid", 0.5);
  ASSERT_EQ(times.Seconds().size(), 2u);
  EXPECT_EQ(times.Seconds().at("grid"), 0.75);
  times.Clear();
  EXPECT_TRUE(times.Seconds().empty());
}

TEST(PhaseTimer, AddsItsOwnLifetimeAndNoMore) {
  PhaseTimes times;
  const Stopwatch outside;
  double inside_seconds = 0;
  {
    const PhaseTimer timer(times, "wait");
    const Stopwatch inside;
    while (inside.Seconds() < 1e-3) {
    }
    inside_seconds = inside.Seconds();
  }
  EXPECT_GE(times.Seconds().at("wait"), inside_seconds);
  EXPECT_LE(times.Seconds().at("wait"), outside.Seconds());
}

TEST(Stopwatch, StartsAnewWithRestart) {
  Stopwatch first;
  while (first.Seconds() < 1e-3) {
  }
  const Stopwatch second;
  const double before = first.Seconds();
  first.Restart();
  const double since_restart = first.Seconds();
  const double since_second = second.Seconds();
  EXPECT_LE(since_restart, since_second);  // restarted after the second one began
  EXPECT_GE(before, 1e-3);
}

TEST(ProcessorStopwatch, CountsWorkAndNotWaiting) {
  const Stopwatch wall;
  const ProcessorStopwatch processor;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_LT(processor.Seconds(), 0.05);
  while (processor.Seconds() < 0.02) {
  }
  EXPECT_GE(wall.Seconds(), 0.1 + 0.01) << "working takes wall time, too";
}

}  // namespace
}  // namespace sph
