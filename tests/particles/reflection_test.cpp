// Reflecting walls (the tutorial's): the particle is put back on the wall, its speed towards it turned round and
// reduced.
#include <gtest/gtest.h>

#include <cmath>

#include "particles/one_particle.hpp"

namespace sph {
namespace {

constexpr double kDt = 0.01;

Parameters Reflecting(Vec2 position, Vec2 velocity, Wall wall, double restitution) {
  Parameters one = OneParticle(position, velocity, kDt);
  one.walls = {std::move(wall)};
  one.wall.kind = WallKind::kReflect;
  one.wall.restitution = restitution;
  return one;
}

TEST(Reflection, PutsTheParticleOnTheWallAndTurnsTheNormalVelocity) {
  for (const Integration integration : kAllIntegrations) {
    Parameters one = Reflecting({0.995, 0.3}, {2, -3}, {"right", FluidSide::kLeft, 1, 0, 1, 1}, 0.5);
    one.integration = integration;
    ParticleSystem system(one);
    system.Reset();
    system.Step();
    EXPECT_EQ(system.State().x[0], 1);
    EXPECT_EQ(system.State().vx[0], -1);
    EXPECT_EQ(system.State().vx_prev[0], -1);
    EXPECT_EQ(system.State().vy[0], -3) << "the wall is smooth";
    EXPECT_DOUBLE_EQ(system.State().y[0], 0.27);
  }
}

TEST(Reflection, OfAMovingWallIsRelativeToIt) {
  // Towards the wall with -1 m/s, the wall coming with +2: relative -3, after it +1.5, so 3.5.
  ParticleSystem system(Reflecting({0, 0.01}, {0, -1}, {"floor", FluidSide::kAbove, 0, 2, -10, 10}, 0.5));
  system.Reset();
  system.Step();
  EXPECT_EQ(system.State().y[0], 0.02) << "where the wall is now";
  EXPECT_EQ(system.State().vy_prev[0], 3.5);
}

TEST(Reflection, WithoutLossKeepsTheSpeedForEver) {
  Parameters one = Reflecting({0.5, 0.5}, {1.3, 0}, {"right", FluidSide::kLeft, 1, 0, 1, 1}, 1);
  one.walls.push_back({"left", FluidSide::kRight, 0, 0, 0, 0});
  ParticleSystem system(one);
  system.Reset();
  for (int k = 0; k < 1000; ++k) {
    system.Step();
    ASSERT_EQ(std::abs(system.State().vx_prev[0]), 1.3);
    ASSERT_GE(system.State().x[0], 0);
    ASSERT_LE(system.State().x[0], 1);
  }
}

TEST(Reflection, NeverLetsAParticleRestBelowTheFloor) {
  Parameters one = Reflecting({0, 0.5}, {0, 0}, {"floor", FluidSide::kAbove, 0, 0, 0, 0}, 0.5);
  one.gravity = {0, -9.8};
  ParticleSystem system(one);
  system.Reset();
  double highest = 0;
  for (int k = 0; k < 1000; ++k) {
    system.Step();
    ASSERT_GE(system.State().y[0], 0);
    if (k > 900) highest = std::max(highest, system.State().y[0]);
  }
  EXPECT_LT(highest, 9.8 * kDt * kDt);  // what is left of bouncing is less than a step's fall
}

}  // namespace
}  // namespace sph
