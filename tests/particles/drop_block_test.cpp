// A dropped block has exactly its number, lands on nobody, and says why when it cannot come.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "particles/diagnostics.hpp"
#include "particles/particle_system.hpp"

namespace sph {
namespace {

/// A tank of 2 x 1.5 m, 200 particles on its floor; a block of 30 at mid-height.
Parameters Tank() {
  Parameters tank;
  tank.fluid.particles = 200;
  tank.fluid.region.box = {-1, 0, 1, 0.5};
  tank.fluid.arrange = Arrangement::kLattice;
  tank.drop.particles = 30;
  tank.drop.region.box = {-0.25, 0.3, 0.25, 0.7};
  tank.drop.spacing = 0.08;
  tank.drop.velocity = {0.1, -1};
  tank.particle_limit = 100000;
  tank.particle_mass = 1;
  tank.time_step = 0.001;
  tank.gravity = {0, -10};
  tank.walls = {{"left", FluidSide::kRight, -1, 0, -1, -1},
                {"right", FluidSide::kLeft, 1, 0, 1, 1},
                {"floor", FluidSide::kAbove, 0, 0, 0, 0},
                {"ceiling", FluidSide::kBelow, 1.5, 0, 1.5, 1.5}};
  return tank;
}

double LeastDistance(const Particles& p) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < p.Size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, Length(p.Position(i) - p.Position(j)));
  }
  return least;
}

TEST(DropBlock, AddsExactlyItsNumberAsNewParticlesOfItsVelocity) {
  ParticleSystem system(Tank());
  system.Reset();
  system.Step();
  ASSERT_EQ(system.DropBlock(), "");
  ASSERT_EQ(system.State().Size(), 230u);
  for (std::size_t i = 200; i < 230; ++i) {
    EXPECT_EQ(system.State().id[i], i);
    EXPECT_EQ(system.State().Velocity(i), (Vec2{0.1, -1}));
    EXPECT_DOUBLE_EQ(system.State().vy_prev[i], -1 + 0.0005 * 10) << "half a step back, as at the start";
    EXPECT_EQ(system.State().mass[i], 1);
  }
}

TEST(DropBlock, LeavesTheOthersAsTheyAre) {
  ParticleSystem with(Tank()), without(Tank());
  for (ParticleSystem* system : {&with, &without}) {
    system->Reset();
    for (int k = 0; k < 3; ++k) system->Step();
  }
  with.DropBlock();
  with.Step();
  without.Step();
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(with.State().Position(i), without.State().Position(i));
    EXPECT_EQ(with.State().vy_prev[i], without.State().vy_prev[i]);
  }
}

TEST(DropBlock, NeverPutsAParticleOnAnotherOrIntoAWallUntilTheTankIsFull) {
  const Parameters tank = Tank();
  ParticleSystem system(tank);
  system.Reset();
  std::string why;
  while (why.empty()) {
    const std::size_t before = system.State().Size();
    why = system.DropBlock();
    ASSERT_EQ(system.State().Size(), why.empty() ? before + 30 : before);
    ASSERT_LT(before, 1000u) << "more than the tank holds";
  }
  EXPECT_GT(system.State().Size(), 230u);
  EXPECT_NE(why.find("no room"), std::string::npos) << why;
  EXPECT_GE(LeastDistance(system.State()), 0.9 * 0.07);  // 0.9 of a spacing of 0.07 (fluid) or 0.08 (drops)
  for (std::size_t i = 0; i < system.State().Size(); ++i) {
    for (const Wall& wall : tank.walls) ASSERT_LE(wall.Depth(system.State().Position(i)), 0);
  }
}

TEST(DropBlock, StopsAtTheParticleLimitAndNamesIt) {
  Parameters tank = Tank();
  tank.particle_limit = 259;
  ParticleSystem system(tank);
  system.Reset();
  EXPECT_EQ(system.DropBlock(), "");
  const std::string why = system.DropBlock();
  EXPECT_NE(why.find("259"), std::string::npos) << why;
  EXPECT_EQ(system.State().Size(), 230u);
}

TEST(DropBlock, SaysSoInASceneWithoutABlock) {
  Parameters tank = Tank();
  tank.drop = {};
  ParticleSystem system(tank);
  system.Reset();
  EXPECT_NE(system.DropBlock(), "");
  EXPECT_EQ(system.State().Size(), 200u);
}

TEST(DropBlock, FindsRoomAboveInATankWithoutACeilingOrWalls) {
  for (const std::size_t walls : {3, 0}) {
    Parameters tank = Tank();
    tank.walls.resize(walls);
    ParticleSystem system(tank);
    system.Reset();
    EXPECT_EQ(system.DropBlock(), "") << walls << " walls";
    EXPECT_EQ(system.DropBlock(), "") << walls << " walls";
    EXPECT_GE(LeastDistance(system.State()), 0.9 * 0.07) << walls << " walls";
  }
}

TEST(DropBlock, DoesNothingToASystemInTrouble) {
  Parameters tank = Tank();
  tank.gravity = {0, std::numeric_limits<double>::quiet_NaN()};
  ParticleSystem system(tank);
  system.Reset();
  system.Step();
  ASSERT_TRUE(system.Trouble());
  EXPECT_NE(system.DropBlock(), "");
  EXPECT_EQ(system.State().Size(), 200u);
}

TEST(DropBlock, ThatWouldBreakEverythingDownIsNotDropped) {
  Parameters tank = Tank();
  tank.drop.velocity = {0, -1e200};
  ParticleSystem system(tank), alone(tank);
  system.Reset();
  alone.Reset();
  const std::string message = system.DropBlock();
  EXPECT_NE(message.find("velocity"), std::string::npos) << message;
  EXPECT_EQ(system.State().Size(), 200u);
  EXPECT_FALSE(system.Trouble());
  for (int k = 0; k < 20; ++k) {
    system.Step();
    alone.Step();
  }
  EXPECT_EQ(Diagnose(system).state_hash, Diagnose(alone).state_hash);
}

TEST(DropBlock, OfALatticeThatIsTooFineIsGivenUp) {
  Parameters tank = Tank();
  tank.drop.spacing = 1e-12;
  ParticleSystem system(tank);
  system.Reset();
  system.DropBlock();
  EXPECT_LE(system.State().Size(), 200u + tank.drop.particles) << "and does not take for ever";
}

}  // namespace
}  // namespace sph
