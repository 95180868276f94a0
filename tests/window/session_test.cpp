// What a person at the keyboard has in hand: requests kept and dropped, reasons given, no state left behind.
#include "window/session.hpp"

#include <gtest/gtest.h>

#include "io/trouble.hpp"
#include "window/sessions.hpp"

namespace sph {
namespace {

TEST(Session, StartsAsTheRequestSays) {
  SceneRequest request;
  request.scene = "toy-star";
  request.particles = 250;
  const Session session(request);
  EXPECT_EQ(session.CurrentScene().name, "toy-star");
  EXPECT_EQ(session.System().State().Size(), 250U);
  EXPECT_FALSE(session.paused);
  EXPECT_EQ(session.System().Steps(), 0);
}

TEST(Session, RefusesASceneThatDoesNotExist) {
  SceneRequest request;
  request.scene = "dam-brake";
  EXPECT_TRUE(Complains<UsageError>([&] { Session session(request); }, {"dam-brake", "dam-break"}));
}

TEST(Session, TheNextSceneHasItsOwnNumberOfParticlesAndTheFirstOnesSeed) {
  SceneRequest request;
  request.particles = 50;
  request.seed = 7;
  Session session(request);
  session.GoToNextScene(1);
  EXPECT_NE(session.System().State().Size(), 50U);
  EXPECT_EQ(session.System().parameters.seed, 7U);
}

TEST(Session, ASceneGoneToStartsAtItsBeginningInTheSameColours) {
  Session session = SessionOf("dam-break");
  session.NextColouring();
  session.Step();
  session.GoToNextScene(1);
  session.GoToNextScene(-1);
  EXPECT_EQ(session.System().Steps(), 0);
  EXPECT_EQ(session.colouring, Colouring::kSpeed);
}

TEST(Session, WhatAKeyHasSetOutlivesAnotherKeyButNotAReset) {
  Session session = SessionOf("dam-break");
  Type(session, "d");
  WallOf(session, "dam").at = 0.5;
  Type(session, "space");
  EXPECT_DOUBLE_EQ(WallOf(session, "dam").at, 0.5);
  EXPECT_DOUBLE_EQ(session.System().parameters.motion_damping, 1.0);
  Type(session, "r");
  EXPECT_DOUBLE_EQ(session.System().parameters.motion_damping, 8.0);
}

TEST(Session, SaysWhyABlockIsNotDropped) {
  Session session = SessionOf("dam-break");
  session.System().parameters.particle_limit = session.System().State().Size();
  Type(session, "space");
  EXPECT_NE(session.message.find("limit"), std::string::npos) << session.message;
  EXPECT_EQ(session.System().State().Size(), session.System().parameters.particle_limit);
}

TEST(Session, AResetEndsAPauseAndTrouble) {
  Session session = SessionWithoutRetries();
  session.paused = true;
  session.System().parameters.time_step = 10;
  for (int i = 0; i < 10; ++i) session.Step();
  ASSERT_TRUE(session.System().Trouble());
  session.Reset();
  EXPECT_FALSE(session.System().Trouble());
  EXPECT_FALSE(session.paused);
}

TEST(Session, GoesBackFromTroubleAndWaits) {
  Session session = SessionWithoutRetries();
  for (int i = 0; i < 10; ++i) session.Step();
  Type(session, "space");  // never undone
  const std::size_t particles = session.System().State().Size();
  session.System().parameters.time_step = 10;
  for (int i = 0; i < 10; ++i) session.Step();
  ASSERT_TRUE(session.System().Trouble());
  Type(session, "b");
  EXPECT_FALSE(session.System().Trouble());
  EXPECT_EQ(session.System().Steps(), 10);
  EXPECT_EQ(session.System().State().Size(), particles);
  EXPECT_TRUE(session.paused);
  Type(session, "p");
  EXPECT_TRUE(session.StepUnlessPaused());
  EXPECT_FALSE(session.System().Trouble()) << "the step is that of the good state, too";
}

TEST(Session, SaysWhenItHasGoneBackWithHalfTheStep) {
  Session session = SessionOf("dam-break", 100, {"method.time_step=0.2"});
  const double step = session.System().parameters.time_step;
  for (int i = 0; i < 100 && session.message.empty(); ++i) session.Step();
  EXPECT_NE(session.message.find("half the step, retry 1 of 3"), std::string::npos) << session.message;
  EXPECT_EQ(session.System().parameters.time_step, step / 2);
}

TEST(Session, BuildsNoSceneWhoseFileIsNotTheOneThatAStateWasSavedWith) {
  SceneRequest elsewhere;
  elsewhere.scene = "toy-star";
  std::uint64_t fingerprint = 1;
  std::vector<std::string> keys;
  std::vector<double> values;
  std::vector<std::byte> state;
  Archive writer = Archive::Writer(state, Archive::Extent::kSameBits);
  TransferRequest(writer, elsewhere);
  writer(fingerprint, keys, values);
  Session session(SceneRequest{});
  Archive reader = Archive::Reader(state, Archive::Extent::kSameBits);
  try {
    session.Transfer(reader);
    FAIL() << "accepted";
  } catch (const TroubleError& error) {
    EXPECT_NE(std::string(error.what()).find("'toy-star'"), std::string::npos) << error.what();
  }
  EXPECT_EQ(session.CurrentScene().name, "dam-break");
}

}  // namespace
}  // namespace sph
