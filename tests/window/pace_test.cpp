// Simulated time keeps pace with the clock, and a frame's work stays within its budget.
#include "window/pace.hpp"

#include <gtest/gtest.h>

#include "window/sessions.hpp"

namespace sph {
namespace {

constexpr double kFrame = 1.0 / 60;  // [s]
constexpr double kPlenty = 1e9;      // [s]: a budget that nothing exceeds

TEST(Pace, FollowsTheClockToWithinAStep) {
  for (const double speed : {0.25, 1.0, 4.0}) {
    Session session = SessionOf("dam-break");
    session.speed = speed;
    Pace pace(kPlenty);
    for (int frame = 1; frame <= 120; ++frame) {
      pace.Advance(session, kFrame);
      const double behind = frame * kFrame * speed - session.System().Time();
      ASSERT_GE(behind, -1e-9);
      ASSERT_LE(behind, session.System().parameters.time_step + 1e-9);
    }
  }
}

TEST(Pace, SaysHowManyStepsItMade) {
  Session session = SessionOf("dam-break");
  Pace pace(kPlenty);
  int steps = 0;
  for (int frame = 0; frame < 30; ++frame) steps += pace.Advance(session, kFrame);
  EXPECT_EQ(steps, session.System().Steps());
}

TEST(Pace, MakesAStepAFrameHoweverSmallTheBudget) {
  Session session = SessionOf("dam-break");
  Pace pace(0);
  for (int frame = 0; frame < 10; ++frame) EXPECT_EQ(pace.Advance(session, kFrame), 1);
}

TEST(Pace, GivesUpTimeThatItCannotMakeUpFor) {
  Session session = SessionOf("dam-break");
  Pace pace(0);
  pace.Advance(session, 100);  // as after a suspend
  const double dt = session.System().parameters.time_step;
  EXPECT_EQ(pace.Advance(session, 0.5 * dt), 0);
}

TEST(Pace, MakesUpLaterForAsMuchAsItsDebtAllows) {
  Session session = SessionOf("dam-break");
  const double dt = session.System().parameters.time_step;
  session.speed = 2;
  Pace pace(0, 5 * dt);
  EXPECT_EQ(pace.Advance(session, 100), 1);
  int later = 0;
  while (pace.Advance(session, 0) > 0) ++later;
  EXPECT_NEAR(later, 10, 1) << "so much simulated time goes by in that wall time";
}

TEST(Pace, WaitsUntilAStepIsDue) {
  Session session = SessionOf("dam-break");
  const double dt = session.System().parameters.time_step;
  Pace pace(kPlenty);
  pace.Advance(session, 0.25 * dt);
  EXPECT_NEAR(pace.Wait(session).count(), 0.75 * dt, 1e-9);
  session.speed = 0.5;
  EXPECT_NEAR(pace.Wait(session).count(), 1.5 * dt, 1e-9);
  session.paused = true;
  EXPECT_GT(pace.Wait(session).count(), 1000);
  Type(session, ".");
  EXPECT_LT(pace.Wait(session).count(), 1);
}

TEST(Pace, BoundsTheWorkOfAFrame) {
  Session session = SessionOf("dam-break", 1000);
  constexpr double kBudget = 0.02;  // [s]
  Pace pace(kBudget);
  session.speed = 64;
  const Stopwatch watch;
  int steps = 0;
  int frames = 0;
  for (; frames < 20; ++frames) steps += pace.Advance(session, 1.0);
  // A step more than foreseen may be slow on a busy machine: a mean over frames, with a factor to spare.
  EXPECT_LT(watch.Seconds() / frames, 5 * kBudget);
  EXPECT_GT(steps, frames);
}

TEST(Pace, DoesNothingWhilePausedAndDoesNotCatchUpAfterwards) {
  Session session = SessionOf("dam-break");
  Pace pace(kPlenty);
  session.paused = true;
  for (int frame = 0; frame < 60; ++frame) EXPECT_EQ(pace.Advance(session, kFrame), 0);
  EXPECT_EQ(session.System().Steps(), 0);
  session.paused = false;
  pace.Advance(session, kFrame);
  EXPECT_LE(session.System().Time(), kFrame + 1e-9);
}

TEST(Pace, MakesTheSingleStepsAskedFor) {
  Session session = SessionOf("dam-break");
  Pace pace(kPlenty);
  Type(session, ".");
  EXPECT_EQ(pace.Advance(session, kFrame), 1);
  EXPECT_EQ(pace.Advance(session, kFrame), 0);
  Type(session, ".");
  Type(session, ".");
  EXPECT_EQ(pace.Advance(session, kFrame), 2);
  EXPECT_EQ(session.System().Steps(), 3);
}

TEST(Pace, StopsWhenTheSystemIsInTroubleAndStartsAfreshAfterAReset) {
  Session session = SessionWithoutRetries();
  Pace pace(kPlenty);
  session.System().parameters.time_step = 1;  // far too long
  pace.Advance(session, 20);
  ASSERT_TRUE(session.System().Trouble());
  const long steps = session.System().Steps();
  EXPECT_EQ(pace.Advance(session, 20), 0);
  EXPECT_EQ(session.System().Steps(), steps);
  Type(session, "r");
  EXPECT_FALSE(session.System().Trouble());
  pace.Advance(session, kFrame);
  EXPECT_LE(session.System().Time(), kFrame + 1e-9);
}

}  // namespace
}  // namespace sph
