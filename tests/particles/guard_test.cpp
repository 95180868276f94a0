#include "particles/guard.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "particles/diagnostics.hpp"

namespace sph {
namespace {

/// Particles on the spring of a central force, which leapfrog holds for dt < 2/sqrt(lambda) = 0.2 s.
class Springs : public ParticleSystem {
 public:
  explicit Springs(double time_step) : ParticleSystem(With(time_step)) { Reset(); }

 protected:
  double LongestMove() const override { return 10; }

 private:
  static Parameters With(double time_step) {
    Parameters base;
    base.fluid.particles = 20;
    base.fluid.region.box = {0, 0, 1, 1};
    base.particle_mass = 1;
    base.time_step = time_step;
    base.central_force = 100;
    return base;
  }
};

TEST(Guard, ChangesNothingOfARunThatHolds) {
  Springs alone(0.1), guarded(0.1);
  Guard guard(guarded, 3);
  for (int step = 0; step < 500; ++step) {
    alone.Step();
    guard.Step();
  }
  EXPECT_EQ(Diagnose(alone).state_hash, Diagnose(guarded).state_hash);
  EXPECT_EQ(guard.Retreats(), 0);
}

TEST(Guard, HalvesTheStepUntilItHolds) {
  Springs system(0.7);
  Guard guard(system, 3);
  for (int step = 0; step < 2000; ++step) guard.Step();
  EXPECT_FALSE(system.Trouble());
  EXPECT_EQ(guard.Retreats(), 2);
  EXPECT_EQ(system.parameters.time_step, 0.7 / 4) << "below 0.2 s";
  EXPECT_NE(guard.LastRetreat().find("retry 2 of 3"), std::string::npos) << guard.LastRetreat();
}

TEST(Guard, GivesUpAfterItsRetriesAndSaysWhichStepWouldHold) {
  Springs system(3.2);
  Guard guard(system, 3);
  for (int step = 0; step < 2000; ++step) guard.Step();
  ASSERT_TRUE(system.Trouble());
  EXPECT_EQ(system.parameters.time_step, 0.4) << "halved three times";
  const std::string message = system.Trouble()->Message();
  EXPECT_NE(message.find("dt <= 0.16 s would have held: central force"), std::string::npos) << message;
  const long steps = system.Steps();
  guard.Step();
  EXPECT_EQ(system.Steps(), steps);
}

TEST(Guard, WithoutRetriesLeavesTheFirstTrouble) {
  Springs system(0.7);
  Guard guard(system, 0);
  for (int step = 0; step < 2000; ++step) guard.Step();
  EXPECT_TRUE(system.Trouble());
  EXPECT_EQ(system.parameters.time_step, 0.7);
}

TEST(Guard, GoesBackToAStateThatIsOldEnoughToBeGood) {
  Springs system(0.1);
  Guard guard(system, 3);
  for (long step = 0; step < 3 * Guard::kStepsApart + 5; ++step) guard.Step();
  guard.GoBack();
  EXPECT_EQ(system.Steps(), 2 * Guard::kStepsApart);
  Springs other(0.1);
  for (long step = 0; step < 2 * Guard::kStepsApart; ++step) other.Step();
  EXPECT_EQ(Diagnose(system).state_hash, Diagnose(other).state_hash);
}

TEST(Guard, NeverGoesBackBeyondAMark) {
  Springs system(0.1);
  Guard guard(system, 3);
  for (int step = 0; step < 1000; ++step) guard.Step();
  guard.Mark();
  guard.Step();
  guard.GoBack();
  EXPECT_EQ(system.Steps(), 1000);
}

/// Counts the segments that it is asked to draw.
class Segments : public Canvas {
 public:
  Colouring WantedColouring() const override { return Colouring::kBlackDisks; }
  void DrawDisks(std::span<const double>, std::span<const double>, double, std::span<const double>) override {}
  void DrawWall(Vec2 a, Vec2 b) override {
    ++count;
    last = {a, b};
  }
  int count = 0;
  std::pair<Vec2, Vec2> last;
};

TEST(Guard, ShowsTheParticleThatTroubleBeganWith) {
  Springs system(0.7);
  Segments sound, broken;
  system.Draw(sound);
  while (!system.Trouble()) system.Step();
  system.Draw(broken);
  EXPECT_EQ(sound.count, 0);
  EXPECT_EQ(broken.count, 13) << "a ring, and its way";
  EXPECT_EQ(broken.last.second, system.Trouble()->position);
}

TEST(Guard, ResetGivesItsRetriesBack) {
  Springs system(0.7);
  Guard guard(system, 2);
  for (int round = 0; round < 3; ++round) {
    system.Reset();
    guard.Reset();
    for (int step = 0; step < 1000; ++step) guard.Step();
    EXPECT_FALSE(system.Trouble());
    EXPECT_EQ(guard.Retreats(), 2);
  }
}

TEST(Guard, HalvesWhatAnAdaptiveStepTakesOfTheLimits) {
  Springs system(0.1);
  system.parameters.adaptive_step = true;
  Guard guard(system, 3);
  guard.Step();
  const double before = system.parameters.time_step;
  // A limit that the system does not know of.
  struct Kick : Springs {
    using Springs::Springs;
    void Throw() { particles_.vx_prev[3] = 1e6; }
  } kicked(0.1);
  kicked.parameters.adaptive_step = true;
  Guard of_kicked(kicked, 3);
  of_kicked.Step();
  kicked.Throw();
  of_kicked.Step();
  EXPECT_EQ(of_kicked.Retreats(), 1);
  EXPECT_EQ(kicked.parameters.caution, 0.5);
  of_kicked.Step();
  EXPECT_FALSE(kicked.Trouble()) << "the kick is undone";
  EXPECT_LT(kicked.parameters.time_step, before);
}

TEST(Guard, GivenUpStandsAtAStateThatWasInOrder) {
  Springs system(3.2), start(3.2);
  Guard guard(system, 0);
  while (!system.Trouble()) guard.Step();
  EXPECT_EQ(system.Steps(), 0);
  EXPECT_GT(system.Trouble()->step, 0);
  EXPECT_EQ(Diagnose(system).state_hash, Diagnose(start).state_hash);
}

TEST(Guard, NamesStepTimeParticleStateLimitAndWhatWouldHold) {
  Springs system(0.7);
  Guard guard(system, 0);
  while (!system.Trouble()) guard.Step();
  const Instability& trouble = *system.Trouble();
  const std::string message = trouble.Message();
  for (const std::string& part :
       {fmt::format("step {}, t = {:.6g} s", trouble.step, trouble.time), fmt::format("particle {} at (", trouble.id),
        fmt::format("({:.4g}, {:.4g}) m", trouble.position.x, trouble.position.y),
        fmt::format("velocity ({:.4g}, {:.4g}) m/s", trouble.velocity.x, trouble.velocity.y),
        std::string("moved further in the step"), std::string("dt <= 0.16 s would have held: central force")}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
}

TEST(Guard, ShowsWhereTheParticleIsOnceTheSystemWasPutBack) {
  Springs system(0.7);
  Guard guard(system, 0);
  while (!system.Trouble()) guard.Step();
  Segments seen;
  system.Draw(seen);
  EXPECT_EQ(seen.last.first, system.State().Position(system.Trouble()->id)) << "the line begins where it is";
}

TEST(Guard, FindsOutThatTheStepOfAnAdaptiveRunHasVanished) {
  Springs system(0.1);
  system.parameters.adaptive_step = true;
  system.Step();
  system.parameters.central_force = 1e30;  // a step of 1e-15 s: the run would never end
  Guard guard(system, 2);
  for (int k = 0; k < 10; ++k) guard.Step();
  ASSERT_TRUE(system.Trouble());
  EXPECT_NE(system.Trouble()->limit.find("below a millionth of the scene's 0.1 s: central force"), std::string::npos)
      << system.Trouble()->limit;
}

}  // namespace
}  // namespace sph
