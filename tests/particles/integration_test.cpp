// Orders of accuracy, measured on motions that are known exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "particles/one_particle.hpp"

namespace sph {
namespace {

constexpr double kLambda = 4.0;  // [1/s^2]
constexpr double kNu = 0.8;      // [1/s]
const Vec2 kStart{1.0, -0.5};    // [m]
const Vec2 kSpeed{0.7, 1.1};     // [m/s]

/// x'' = -lambda x - nu x' from x0, v0: e^(-nu t/2) (x0 cos wt + (v0 + nu x0/2)/w sin wt).
double DampedOscillator(double x0, double v0, double nu, double t) {
  const double w = std::sqrt(kLambda - nu * nu / 4);
  return std::exp(-nu * t / 2) * (x0 * std::cos(w * t) + (v0 + nu * x0 / 2) / w * std::sin(w * t));
}

/// Distance from the exact position after 3 s.
double Error(Integration integration, Vec2 velocity, double nu, double time_step) {
  Parameters one = OneParticle(kStart, velocity, time_step);
  one.integration = integration;
  one.central_force = kLambda;
  one.motion_damping = nu;
  ParticleSystem system(one);
  system.Reset();
  RunFor(system, 3.0);
  const Vec2 exact{DampedOscillator(kStart.x, velocity.x, nu, 3.0), DampedOscillator(kStart.y, velocity.y, nu, 3.0)};
  return Length(system.State().Position(0) - exact);
}

/// From the errors at two steps, both so small that the next order is a percent of the first.
double Order(Integration integration, Vec2 velocity, double nu) {
  return std::log2(Error(integration, velocity, nu, 0.01) / Error(integration, velocity, nu, 0.005));
}

TEST(Integration, LeapFrogIsOfSecondOrderWithDamping) {
  EXPECT_NEAR(Order(Integration::kLeapFrog, {0, 0}, kNu), 2, 0.1);
}

TEST(Integration, LeapFrogIsOfSecondOrderWithDampingFromAMovingStart) {
  EXPECT_NEAR(Order(Integration::kLeapFrog, kSpeed, kNu), 2, 0.1);
}

TEST(Integration, PublishedLeapFrogIsOfSecondOrderWithoutDampingOnly) {
  EXPECT_NEAR(Order(Integration::kLeapFrogPublished, kSpeed, 0), 2, 0.1);
  EXPECT_NEAR(Order(Integration::kLeapFrogPublished, kSpeed, kNu), 1, 0.1);
  EXPECT_NEAR(Order(Integration::kLeapFrogPublished, {0, 0}, kNu), 1, 0.1);
}

TEST(Integration, SymplecticEulerIsOfFirstOrder) {
  EXPECT_NEAR(Order(Integration::kSymplecticEuler, kSpeed, 0), 1, 0.1);
  EXPECT_NEAR(Order(Integration::kSymplecticEuler, kSpeed, kNu), 1, 0.1);
}

TEST(Integration, SecondOrderIsWorthHavingAtThePapersStep) {
  EXPECT_LT(20 * Error(Integration::kLeapFrog, kSpeed, kNu, 0.004),
            Error(Integration::kLeapFrogPublished, kSpeed, kNu, 0.004));
}

Parameters Falling(Integration integration) {
  Parameters one = OneParticle(kStart, kSpeed, 0.01);
  one.integration = integration;
  one.gravity = {0.5, -9.8};
  return one;
}

TEST(Integration, LeapFrogFallsExactly) {
  for (const Integration integration : {Integration::kLeapFrog, Integration::kLeapFrogPublished}) {
    const Parameters one = Falling(integration);
    ParticleSystem system(one);
    system.Reset();
    RunFor(system, 1.0);
    // x0 + v0 t + g t^2/2, but for the round-off of 100 steps on numbers up to 10.
    EXPECT_NEAR(system.State().x[0], kStart.x + kSpeed.x + 0.25, 1e-13);
    EXPECT_NEAR(system.State().y[0], kStart.y + kSpeed.y - 4.9, 1e-13);
  }
}

TEST(Integration, SymplecticEulerFallsHalfAStepTooFast) {
  ParticleSystem system(Falling(Integration::kSymplecticEuler));
  system.Reset();
  RunFor(system, 1.0);
  EXPECT_NEAR(system.State().y[0], kStart.y + kSpeed.y - 4.9 * (1 + 0.01), 1e-13);  // g t (t + dt)/2
}

TEST(Integration, VelocityBesideTheHalfStepsIsOfTheTimeThatItsFormSays) {
  // Under constant acceleration: v(t + dt) for the second-order form and Euler, the paper's eq. 15 lags a step behind.
  for (const Integration integration : kAllIntegrations) {
    ParticleSystem system(Falling(integration));
    system.Reset();
    RunFor(system, 0.2);
    const double lag = integration == Integration::kLeapFrogPublished ? 0.01 : 0;
    EXPECT_NEAR(system.State().vy[0], kSpeed.y - 9.8 * (0.2 - lag), 1e-13);
    const double half_step = integration == Integration::kSymplecticEuler ? 0 : 0.005;
    EXPECT_NEAR(system.State().vy_prev[0], kSpeed.y - 9.8 * (0.2 - half_step), 1e-13);
  }
}

TEST(Integration, StartsWithHalfAStepBackwards) {
  Parameters one = Falling(Integration::kLeapFrog);
  one.central_force = kLambda;
  for (const double nu : {0.0, kNu}) {
    one.motion_damping = nu;
    for (const Integration integration : {Integration::kLeapFrog, Integration::kLeapFrogPublished}) {
      one.integration = integration;
      ParticleSystem system(one);
      system.Reset();
      // v(-dt/2) = v(0) - dt/2 a(0), a(0) with all that acts, damping included.
      EXPECT_DOUBLE_EQ(system.State().vx_prev[0], kSpeed.x - 0.005 * (0.5 - kLambda * kStart.x - nu * kSpeed.x));
      EXPECT_DOUBLE_EQ(system.State().vy_prev[0], kSpeed.y - 0.005 * (-9.8 - kLambda * kStart.y - nu * kSpeed.y));
      EXPECT_EQ(system.State().Velocity(0), kSpeed);
    }
  }
}

TEST(Integration, LeapFrogsOscillationNeverGrowsUpToItsLimitOfStability) {
  // omega dt = 1.99 of 2. The discrete motion is an ellipse around the origin; beyond 2 it grows without bound.
  Parameters one = OneParticle({1, 0}, {0, 0}, 1.99 / std::sqrt(kLambda));
  one.central_force = kLambda;
  ParticleSystem stable(one);
  stable.Reset();
  double greatest = 0;
  for (int k = 0; k < 10000; ++k) {
    stable.Step();
    greatest = std::max(greatest, std::abs(stable.State().x[0]));
  }
  EXPECT_LT(greatest, 1 / std::sqrt(1 - 1.99 * 1.99 / 4) * 1.001);  // the ellipse's half axis, from x0 = 1 at rest
  one.time_step = 2.01 / std::sqrt(kLambda);
  ParticleSystem unstable(one);
  unstable.Reset();
  for (int k = 0; k < 200; ++k) unstable.Step();
  EXPECT_GT(std::abs(unstable.State().x[0]), 1e6);
}

TEST(Integration, StrongDampingOfAnySizeNeverSpeedsUp) {
  // The second-order form keeps |v+| <= |v-| for every nu >= 0: (1 - s)/(1 + s) is within -1 and 1.
  for (const double nu : {1.0, 100.0, 1e6}) {
    Parameters one = OneParticle({0, 0}, {1, 0}, 0.01);
    one.motion_damping = nu;
    ParticleSystem system(one);
    system.Reset();
    const double start = std::abs(system.State().vx_prev[0]);
    for (int k = 0; k < 10; ++k) system.Step();
    EXPECT_LE(std::abs(system.State().vx_prev[0]), start) << nu;
  }
}

}  // namespace
}  // namespace sph
