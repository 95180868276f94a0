// --keys: what is accepted, what is refused, and when the keys are pressed.
#include "window/key_script.hpp"

#include <gtest/gtest.h>

#include "io/trouble.hpp"
#include "window/sessions.hpp"

namespace sph {
namespace {

void RunUntil(Session& session, KeyScript& script, double time) {
  while (session.System().Time() < time - 1e-9) {
    script.Play(session);
    session.Step();
  }
  script.Play(session);
}

TEST(KeyScript, PressesAKeyAtItsTimeAndNotBefore) {
  Session session = SessionOf("dam-break");
  KeyScript script("0.1:d", session.CurrentScene());
  const double dt = session.System().parameters.time_step;
  RunUntil(session, script, 0.1 - 1.5 * dt);
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, -0.35);
  RunUntil(session, script, 0.1 + dt);
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, 0.95);
}

TEST(KeyScript, PressesInTheOrderOfTimeNotOfWriting) {
  Session session = SessionOf("dam-break");
  KeyScript script("0.2:c,0.1:c,0:c", session.CurrentScene());
  EXPECT_DOUBLE_EQ(script.End(), 0.2);
  script.Play(session);
  EXPECT_EQ(session.colouring, Colouring::kSpeed);
  RunUntil(session, script, 0.15);
  EXPECT_EQ(session.colouring, Colouring::kPressure);
  RunUntil(session, script, 0.25);
  EXPECT_EQ(session.colouring, Colouring::kDensity);
}

TEST(KeyScript, PressesKeysOfTheSameTimeInTheOrderOfWriting) {
  Session session = SessionOf("dam-break");
  KeyScript script("0:d,0:r", session.CurrentScene());
  script.Play(session);
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, -0.35);
}

TEST(KeyScript, AHeldArrowMovesTheWallBySpeedTimesDuration) {
  Session session = SessionOf("dam-break");
  KeyScript script("0.1:Right:1.2", session.CurrentScene());
  RunUntil(session, script, 1.5);
  const double speed = session.CurrentScene().arrow_speed;
  // Press and release are each late by less than a step.
  EXPECT_NEAR(WallOf(session, "dam").at, -0.35 + speed * 1.2, speed * session.System().parameters.time_step);
}

TEST(KeyScript, ATappedArrowIsHeldForATenthOfASecond) {
  Session session = SessionOf("dam-break");
  KeyScript script("0:Left", session.CurrentScene());
  RunUntil(session, script, 0.5);
  const double speed = session.CurrentScene().arrow_speed;
  EXPECT_NEAR(WallOf(session, "dam").at, -0.35 - speed * 0.1, speed * session.System().parameters.time_step);
}

TEST(KeyScript, AnEmptyScriptDoesNothing) {
  Session session = SessionOf("dam-break");
  for (KeyScript script : {KeyScript(), KeyScript("", session.CurrentScene())}) {
    script.Play(session);
    EXPECT_DOUBLE_EQ(script.End(), 0);
  }
  EXPECT_TRUE(session.message.empty());
}

TEST(KeyScript, RefusesAnUnknownKeyAndNamesTheNearest) {
  const Session session = SessionOf("dam-break");
  const auto read = [&] { KeyScript("1:Lft", session.CurrentScene()); };
  EXPECT_TRUE(Complains<UsageError>(read, {"--keys", "'Lft'", "'Left'", " space"}));
}

TEST(KeyScript, RefusesEntriesOfAnotherForm) {
  const Session session = SessionOf("dam-break");
  for (const char* text :
       {"d", "4:", ":d", "4:d:", "4:d:1:2", "four:d", "-1:d", "nan:d", "inf:d", "4:d:-1", "4:d,", "4 :d", "4:d;5:r"}) {
    const auto read = [&] { KeyScript(text, session.CurrentScene()); };
    EXPECT_TRUE(Complains<UsageError>(read, {"--keys"})) << text;
  }
}

}  // namespace
}  // namespace sph
