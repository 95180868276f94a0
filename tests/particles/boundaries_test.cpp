// The penalty walls (paper, IV-D): a single particle's step, worked out by hand, and where it comes to rest.
#include <gtest/gtest.h>

#include <cmath>

#include "particles/one_particle.hpp"

namespace sph {
namespace {

constexpr double kDt = 0.004;
constexpr double kStiffness = 20000;  // [1/s^2], Table I
constexpr double kDamping = 256;      // [1/s], Table I

Wall Floor(double at, double velocity = 0) { return {"floor", FluidSide::kAbove, at, velocity, -10, 10}; }
Wall Right(double at) { return {"right", FluidSide::kLeft, at, 0, -10, 10}; }

Parameters BetweenWalls(Vec2 position, Vec2 velocity, std::vector<Wall> walls, Integration integration) {
  Parameters one = OneParticle(position, velocity, kDt);
  one.integration = integration;
  one.walls = std::move(walls);
  one.wall.stiffness = kStiffness;
  one.wall.damping = kDamping;
  return one;
}

/// Velocity half a step after the start, at which walls do not act yet, so that v(-dt/2) is v0.
double HalfStepVelocity(Integration integration, double v, double push, double damping, double wall_velocity) {
  if (integration == Integration::kLeapFrog) {
    // The mean of both half steps is damped: (v+ - v)/dt = push - damping ((v + v+)/2 - wall).
    const double s = 0.5 * damping * kDt;
    return (v * (1 - s) + (push + damping * wall_velocity) * kDt) / (1 + s);
  }
  return v + kDt * (push - damping * (v - wall_velocity));
}

class EveryIntegration : public ::testing::TestWithParam<Integration> {};
INSTANTIATE_TEST_SUITE_P(Boundaries, EveryIntegration, ::testing::ValuesIn(kAllIntegrations));

TEST_P(EveryIntegration, InsideAWallIsPushedByItsDepthAndDampedInBothDirections) {
  const double depth = 0.01;
  ParticleSystem system(BetweenWalls({0.3, -1 - depth}, {0.2, -0.5}, {Floor(-1)}, GetParam()));
  system.Reset();
  system.Step();
  const double vx = HalfStepVelocity(GetParam(), 0.2, 0, kDamping, 0);
  const double vy = HalfStepVelocity(GetParam(), -0.5, kStiffness * depth, kDamping, 0);
  EXPECT_NEAR(system.State().vx_prev[0], vx,
              1e-12);  // round-off: depth is a difference of numbers near 1, times 20 000 dt
  EXPECT_NEAR(system.State().vy_prev[0], vy, 1e-12);
  EXPECT_NEAR(system.State().y[0], -1 - depth + kDt * vy, 1e-14);
  EXPECT_NEAR(system.DeepestPenetration(), depth, 1e-15);
}

TEST_P(EveryIntegration, MotionDampingAndWallDampingAddUp) {
  Parameters one = BetweenWalls({0, -1.01}, {0, 0}, {Floor(-1)}, GetParam());
  one.motion_damping = 8;
  one.wall.damping = kDamping - 8;
  ParticleSystem system(one);
  system.Reset();
  system.Step();
  const double vy = HalfStepVelocity(GetParam(), 0, kStiffness * 0.01, kDamping, 0);
  EXPECT_NEAR(system.State().vy_prev[0], vy, 1e-12);
}

TEST_P(EveryIntegration, AMovingWallCarriesTheParticleAlong) {
  // Damping is relative to the wall: at the wall's speed only the push is left.
  ParticleSystem system(BetweenWalls({0, -1.01}, {0, 0.5}, {Floor(-1, 0.5)}, GetParam()));
  system.Reset();
  system.Step();
  EXPECT_NEAR(system.State().vy_prev[0], HalfStepVelocity(GetParam(), 0.5, kStiffness * 0.01, kDamping, 0.5), 1e-12);
  EXPECT_DOUBLE_EQ(system.parameters.walls[0].at, -1 + 0.5 * kDt);
}

TEST_P(EveryIntegration, InACornerBothWallsPushAndDamp) {
  ParticleSystem system(BetweenWalls({1.02, -1.01}, {0.3, 0}, {Floor(-1), Right(1)}, GetParam()));
  system.Reset();
  system.Step();
  EXPECT_NEAR(system.State().vx_prev[0], HalfStepVelocity(GetParam(), 0.3, -kStiffness * 0.02, 2 * kDamping, 0), 1e-12);
  EXPECT_NEAR(system.State().vy_prev[0], HalfStepVelocity(GetParam(), 0, kStiffness * 0.01, 2 * kDamping, 0), 1e-12);
}

TEST_P(EveryIntegration, OnTheWallOrInTheFluidNothingActs) {
  for (const double y : {-1.0, -0.5}) {
    ParticleSystem system(BetweenWalls({0, y}, {0.2, 0}, {Floor(-1)}, GetParam()));
    system.Reset();
    system.Step();
    EXPECT_EQ(system.State().vx_prev[0], 0.2) << y;
    EXPECT_EQ(system.State().vy_prev[0], 0) << y;
    EXPECT_EQ(system.DeepestPenetration(), 0) << y;
  }
}

TEST_P(EveryIntegration, ParticlesComeToRestWhereThePushIsGravity) {
  // One layer of the derivation in SEEDS: K depth = g. A column of n layers on it: K depth = n g = g H/dx.
  Parameters one = BetweenWalls({0, -0.99}, {0, 0}, {Floor(-1)}, GetParam());
  one.gravity = {0, -9.8};
  ParticleSystem system(one);
  system.Reset();
  for (int k = 0; k < 2000; ++k) system.Step();
  EXPECT_NEAR(system.State().y[0], -1 - 9.8 / kStiffness, 1e-9);
  EXPECT_NEAR(system.State().vy_prev[0], 0, 1e-9);
}

TEST(Boundaries, TheDampedWallTakesEnergyFromAParticleThatHitsIt) {
  ParticleSystem system(BetweenWalls({0, -0.99}, {0, -1}, {Floor(-1)}, Integration::kLeapFrog));
  system.Reset();
  for (int k = 0; k < 100; ++k) system.Step();
  EXPECT_GE(system.State().vy_prev[0], 0);
  // Damping 256/s is 0.9 of critical, 2 sqrt(K): the particle creeps back to the wall and hardly leaves it.
  EXPECT_LT(system.State().vy_prev[0], 0.1);
}

TEST(Boundaries, TheUndampedSpringTurnsTheSpeedRound) {
  Parameters one = BetweenWalls({0, -0.999}, {0, -1}, {Floor(-1)}, Integration::kLeapFrog);
  one.wall.damping = 0;
  one.time_step = 1e-4;  // a 220th of the half period of the spring
  ParticleSystem system(one);
  system.Reset();
  for (int k = 0; k < 1000; ++k) system.Step();
  // Where within a step the particle crosses the wall changes the speed by up to K (v dt)^2/(2 v^2) v = 1e-4 v.
  EXPECT_NEAR(system.State().vy_prev[0], 1, 1e-4);
  EXPECT_NEAR(system.DeepestPenetration(), 1 / std::sqrt(kStiffness), 1e-5);  // v/omega
}

TEST(Boundaries, WithoutWallsNothingIsTimedAndNothingPenetrates) {
  ParticleSystem system(BetweenWalls({0, -100}, {0, 0}, {}, Integration::kLeapFrog));
  system.Reset();
  system.Step();
  EXPECT_FALSE(system.Phases().Seconds().contains("walls"));
  EXPECT_EQ(system.DeepestPenetration(), 0);
}

}  // namespace
}  // namespace sph
