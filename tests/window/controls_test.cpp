// The table of controls: complete, free of clashes, and each key does what its row says.
#include "window/controls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scenes/catalogue.hpp"
#include "window/sessions.hpp"

namespace sph {
namespace {

TEST(Controls, EveryPromisedKeyHasOne) {
  // clang-format off
  for (const char* key : {"d", "Left", "Right", "space", "r", "p", ".", "[", "]", "1", "2", "3", "4", "5", "6", "7", "8", "9",
                          "c", "-", "+", "h", "F1", "s", "q", "Esc"}) {
    // clang-format on
    EXPECT_NE(FindControl(key), nullptr) << key;
  }
}

TEST(Controls, NoKeyHasTwo) {
  std::set<std::string> seen;
  for (const std::string& key : AllKeyNames()) EXPECT_TRUE(seen.insert(key).second) << key;
}

TEST(Controls, EveryRowHasKeysWordsAndAnEffect) {
  for (const Control& control : AllControls()) {
    EXPECT_FALSE(control.keys.empty());
    EXPECT_FALSE(control.shown.empty()) << control.does;
    EXPECT_FALSE(control.does.empty()) << control.shown;
    EXPECT_NE(control.press, nullptr) << control.shown;
  }
}

TEST(Controls, AnUnknownKeyIsNoControlAndSaysSo) {
  EXPECT_EQ(FindControl("x"), nullptr);
  Session session = SessionOf("dam-break");
  Type(session, "x");
  EXPECT_NE(session.message.find("x does nothing in the scene dam-break"), std::string::npos) << session.message;
}

TEST(Controls, DBreaksTheDam) {
  Session session = SessionOf("dam-break");
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, -0.35);
  EXPECT_DOUBLE_EQ(session.System().parameters.motion_damping, 8.0);
  Type(session, "d");
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, 0.95);
  EXPECT_DOUBLE_EQ(session.System().parameters.motion_damping, 1.0);
}

TEST(Controls, DSaysThatASceneHasNoDam) {
  Session session = SessionOf("toy-star");
  Type(session, "d");
  EXPECT_EQ(session.message, "d does nothing in the scene toy-star");
}

TEST(Controls, ArrowsMoveTheWallWhileHeldOnly) {
  Session session = SessionOf("dam-break");
  const double speed = session.CurrentScene().arrow_speed;
  PressKey(session, "Right");
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").velocity, speed);
  for (int i = 0; i < 10; ++i) session.Step();
  const double moved = 10 * session.System().parameters.time_step * speed;
  EXPECT_NEAR(WallOf(session, "dam").at, -0.35 + moved, 1e-12);
  ReleaseKey(session, "Right");
  session.Step();
  EXPECT_NEAR(WallOf(session, "dam").at, -0.35 + moved, 1e-12);
  PressKey(session, "Left");
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").velocity, -speed);
}

TEST(Controls, TheWallStopsAtTheEndsOfItsRange) {
  Session session = SessionOf("dam-break");
  PressKey(session, "Right");
  const double range = WallOf(session, "dam").highest - WallOf(session, "dam").lowest;
  const double step = session.CurrentScene().arrow_speed * session.System().parameters.time_step;
  for (int i = 0; i < 1.1 * range / step; ++i) session.Step();
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, 0.95);
  PressKey(session, "Left");
  for (int i = 0; i < 1.1 * range / step; ++i) session.Step();
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, -0.75);
}

TEST(Controls, SpaceDropsABlock) {
  Session session = SessionOf("dam-break");
  const std::size_t before = session.System().State().Size();
  Type(session, "space");
  EXPECT_EQ(session.System().State().Size(), before + session.System().parameters.drop.particles);
}

TEST(Controls, RBringsBackTheStartBitByBit) {
  Session session = SessionOf("dam-break");
  const std::vector<double> x = session.System().State().x;
  Type(session, "d");
  Type(session, "space");
  for (int i = 0; i < 5; ++i) session.Step();
  Type(session, "r");
  EXPECT_EQ(session.System().State().x, x);
  EXPECT_EQ(session.System().Steps(), 0);
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, -0.35);
  EXPECT_DOUBLE_EQ(session.System().parameters.motion_damping, 8.0);
}

TEST(Controls, PPausesAndGoesOn) {
  Session session = SessionOf("dam-break");
  Type(session, "p");
  EXPECT_TRUE(session.paused);
  Type(session, "p");
  EXPECT_FALSE(session.paused);
}

TEST(Controls, DotPausesAndAsksForOneStep) {
  Session session = SessionOf("dam-break");
  Type(session, ".");
  EXPECT_TRUE(session.paused);
  EXPECT_TRUE(session.StepUnlessPaused());
  EXPECT_FALSE(session.StepUnlessPaused());
  EXPECT_EQ(session.System().Steps(), 1);
}

TEST(Controls, BracketsGoThroughAllScenesAndRoundAgain) {
  Session session = SessionOf("dam-break");
  std::set<std::string> seen;
  for (std::size_t i = 0; i < SceneNames().size(); ++i) {
    Type(session, "]");
    seen.insert(session.CurrentScene().name);
  }
  EXPECT_EQ(seen.size(), SceneNames().size());
  EXPECT_EQ(session.CurrentScene().name, "dam-break");
  Type(session, "]");
  Type(session, "[");
  EXPECT_EQ(session.CurrentScene().name, "dam-break");
}

TEST(Controls, DigitsNameScenesInTheOrderOfTheCatalogue) {
  Session session = SessionOf("dam-break");
  const std::vector<std::string> names = SceneNames();
  for (std::size_t i = 0; i < std::min<std::size_t>(9, names.size()); ++i) {
    Type(session, std::to_string(i + 1));
    EXPECT_EQ(session.CurrentScene().name, names[i]);
  }
}

TEST(Controls, ADigitWithoutASceneLeavesTheSceneAndSaysSo) {
  if (SceneNames().size() >= 9) GTEST_SKIP() << "there are nine scenes";
  Session session = SessionOf("dam-break");
  Type(session, "9");
  EXPECT_EQ(session.CurrentScene().name, "dam-break");
  EXPECT_FALSE(session.message.empty());
}

TEST(Controls, CGoesThroughTheColourings) {
  Session session = SessionOf("dam-break");
  for (const Colouring next : {Colouring::kSpeed, Colouring::kPressure, Colouring::kDensity, Colouring::kBlackDisks}) {
    Type(session, "c");
    EXPECT_EQ(session.colouring, next);
    EXPECT_EQ(session.message, "colouring: " + NameOf(next));
  }
}

TEST(Controls, SpeedIsHalvedDoubledAndKeptWithinItsRange) {
  Session session = SessionOf("dam-break");
  Type(session, "-");
  EXPECT_DOUBLE_EQ(session.speed, 0.5);
  Type(session, "+");
  EXPECT_DOUBLE_EQ(session.speed, 1);
  Type(session, "=");  // the same key without Shift
  EXPECT_DOUBLE_EQ(session.speed, 2);
  for (int i = 0; i < 20; ++i) Type(session, "+");
  EXPECT_DOUBLE_EQ(session.speed, 64);
  for (int i = 0; i < 20; ++i) Type(session, "-");
  EXPECT_DOUBLE_EQ(session.speed, 1.0 / 64);
}

TEST(Controls, HAndF1ShowAndHideHelp) {
  Session session = SessionOf("dam-break");
  Type(session, "h");
  EXPECT_TRUE(session.show_help);
  Type(session, "F1");
  EXPECT_FALSE(session.show_help);
}

TEST(Controls, SAsksForAPicture) {
  Session session = SessionOf("dam-break");
  Type(session, "s");
  EXPECT_TRUE(session.save_requested);
}

TEST(Controls, QAndEscQuit) {
  for (const char* key : {"q", "Esc"}) {
    Session session = SessionOf("dam-break");
    Type(session, key);
    EXPECT_TRUE(session.quit_requested) << key;
  }
}

}  // namespace
}  // namespace sph
