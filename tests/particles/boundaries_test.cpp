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

/// The depth and speed after `seconds` in the wall, by many small midpoint steps of d'' = -K d - c d'.
Penetration BySmallSteps(const WallParameters& wall, double speed, double seconds) {
  constexpr int kSteps = 100000;
  const double dt = seconds / kSteps;
  const auto pull = [&](double depth, double v) { return -wall.stiffness * depth - wall.damping * v; };
  Penetration now{0, speed};
  for (int k = 0; k < kSteps; ++k) {
    const double half_depth = now.depth + 0.5 * dt * now.speed;
    const double half_speed = now.speed + 0.5 * dt * pull(now.depth, now.speed);
    now = {now.depth + dt * half_speed, now.speed + dt * pull(half_depth, half_speed)};
  }
  return now;
}

TEST(Boundaries, PenetrationIsTheDampedSpringsWhateverItsDamping) {
  const double critical = 2 * std::sqrt(kStiffness);
  for (const double damping : {0.0, kDamping, critical, 3 * critical}) {
    const WallParameters wall{WallKind::kPenalty, kStiffness, damping, 0};
    const Penetration expected = BySmallSteps(wall, 1.5, kDt);
    const Penetration now = PenetrationAfter(wall, 1.5, kDt);
    EXPECT_NEAR(now.depth, expected.depth, 1e-8 * kDt) << damping;
    EXPECT_NEAR(now.speed, expected.speed, 1e-8) << damping;
  }
}

TEST(Boundaries, AParticleThatGoesInDuringAStepFeelsTheWallFromThatMomentOn) {
  const WallParameters wall = BetweenWalls({}, {}, {}, Integration::kLeapFrog).wall;
  for (const double part : {0.1, 0.3, 0.9}) {  // of the step, before the particle is at the wall
    for (const double wall_velocity : {0.0, 0.4}) {
      const double approach = 2 + wall_velocity;
      ParticleSystem system(
          BetweenWalls({0, -1 + part * approach * kDt}, {0.2, -2}, {Floor(-1, wall_velocity)}, Integration::kLeapFrog));
      system.Reset();
      system.Step();
      const double since = (1 - part) * kDt;
      const Particles& p = system.State();
      const double at = system.parameters.walls[0].at;
      EXPECT_NEAR(at - p.y[0], BySmallSteps(wall, approach, since).depth, 1e-9) << part;
      EXPECT_NEAR(wall_velocity - p.vy[0], BySmallSteps(wall, approach, since).speed, 1e-6) << part;
      const double half_step_ago = since - 0.5 * kDt;
      const double speed = half_step_ago > 0 ? BySmallSteps(wall, approach, half_step_ago).speed : approach;
      EXPECT_NEAR(wall_velocity - p.vy_prev[0], speed, 1e-6) << part;
      EXPECT_EQ(p.vx_prev[0], 0.2) << "along the wall it is damped from the next step on";
    }
  }
}

TEST(Boundaries, ThePublishedFormKnowsOfTheWallOneStepLater) {
  ParticleSystem system(BetweenWalls({0, -0.999}, {0, -2}, {Floor(-1)}, Integration::kLeapFrogPublished));
  system.Reset();
  system.Step();
  EXPECT_DOUBLE_EQ(system.State().y[0], -0.999 - 2 * kDt);
}

TEST(Boundaries, NoParticleGoesDeeperForWhereInAStepItGoesIn) {
  // Without the part of the step behind the wall it would be up to 1.6 times as deep.
  const double v = 2;
  const double exact = [&] {
    double deepest = 0;
    const WallParameters wall = BetweenWalls({}, {}, {}, Integration::kLeapFrog).wall;
    for (double t = 0; t < 0.1; t += 1e-5) deepest = std::max(deepest, PenetrationAfter(wall, v, t).depth);
    return deepest;
  }();
  for (double part = 0; part < 1; part += 0.05) {
    ParticleSystem system(BetweenWalls({0, -1 + part * v * kDt}, {0, -v}, {Floor(-1)}, Integration::kLeapFrog));
    system.Reset();
    for (int k = 0; k < 10; ++k) system.Step();
    EXPECT_LE(system.DeepestPenetration(), 1.02 * exact) << part;
    EXPECT_GE(system.DeepestPenetration(), 0.5 * exact) << part << ": between two steps it may have been deeper";
  }
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
