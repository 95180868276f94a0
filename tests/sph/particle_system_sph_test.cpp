// The whole acceleration of the paper's system, its fields, and what it does when a step breaks down.
#include "sph/particle_system_sph.hpp"

#include <gtest/gtest.h>

#include "particles/diagnostics.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

const Tait kWater{0.5, 2.861, 7};

ParametersSPH Sph(const EquationOfState& equation = kWater) { return {kCloudH, equation, 0, false}; }

/// A block of 20 x 20 particles of the clouds' spacing, over its lower left quarter if `drop` is to find room.
Parameters SmallBlock() {
  Parameters base = NoForces();
  base.fluid = {400, {{0, 0, 0.8, 0.8}, {}, 0}, Arrangement::kJittered, 0.04, 0.01, {}};
  base.drop = {25, {{0, 1, 0.2, 1.2}, {}, 0}, Arrangement::kLattice, 0.04, 0, {}};
  base.particle_mass = 2.861 * 0.04 * 0.04;
  base.particle_limit = 1000;
  base.gravity = {0, -9.8};
  base.motion_damping = 1;
  return base;
}

TEST(ParticleSystemSPH, DensityAndPressureAreThoseOfAllPairs) {
  for (const Cloud& cloud : AllClouds()) {
    const GivenSystem system(NoForces(), Sph(), cloud);
    const auto plain = PlainDensity(CloudOf(system), kCloudH);
    ASSERT_EQ(system.Density().size(), cloud.Size());
    for (std::size_t i = 0; i < cloud.Size(); ++i) {
      ASSERT_NEAR(system.Density()[i], plain[i].value.x, plain[i].RoundOff()) << cloud.name;
      ASSERT_EQ(system.Pressure()[i], kWater.Pressure(system.Density()[i])) << cloud.name;
    }
  }
}

TEST(ParticleSystemSPH, AccelerationIsPressureGravityCentralForceAndDamping) {
  Parameters base = NoForces();
  base.gravity = {0.3, -9.8};
  base.central_force = 1.7;
  base.motion_damping = 0.9;
  for (const Integration integration :
       {Integration::kLeapFrog, Integration::kLeapFrogPublished, Integration::kSymplecticEuler}) {
    base.integration = integration;
    // The second-order leapfrog has the damping in its step instead.
    const double nu = integration == Integration::kLeapFrog ? 0 : base.motion_damping;
    for (const Cloud& cloud : AllClouds()) {
      GivenSystem system(base, Sph(), cloud);
      system.ComputeFields();
      const Particles& p = system.State();
      const auto plain = PlainPressureAcceleration(CloudOf(system), system.Density(), system.Pressure(), kCloudH);
      for (std::size_t i = 0; i < p.Size(); ++i) {
        const Vec2 expected = plain[i].value + base.gravity - 1.7 * p.Position(i) - nu * p.Velocity(i);
        const double round_off =
            2 * plain[i].RoundOff() + 1e-15 * (20 + Length(p.Position(i)));  // a few roundings of what is added
        ASSERT_NEAR(p.ax[i], expected.x, round_off) << cloud.name;
        ASSERT_NEAR(p.ay[i], expected.y, round_off) << cloud.name;
      }
    }
  }
}

TEST(ParticleSystemSPH, StepsWithAnyNumberOfParticlesEvenNone) {
  Parameters base = NoForces();
  base.walls = {{"floor", FluidSide::kAbove, -100, 0, -100, -100}};
  for (const Cloud& cloud : AllClouds()) {
    GivenSystem system(base, Sph(Polytrope{1e-6}), cloud);  // a gas too thin to move anything
    for (int k = 0; k < 3; ++k) system.Step();
    EXPECT_FALSE(system.Trouble()) << cloud.name << ": " << system.Trouble()->Message();
    EXPECT_EQ(system.Steps(), 3);
    EXPECT_EQ(Diagnose(system).density.min > 0, cloud.Size() > 0) << cloud.name;
  }
}

TEST(ParticleSystemSPH, LookingAtTheFieldsDoesNotChangeTheRun) {
  ParticleSystemSPH unseen(SmallBlock(), Sph()), seen(SmallBlock(), Sph());
  unseen.Reset();
  seen.Reset();
  for (int k = 0; k < 20; ++k) {
    unseen.Step();
    seen.Step();
    seen.ComputeFields();
    Diagnose(seen);
  }
  EXPECT_EQ(Diagnose(unseen).state_hash, Diagnose(seen).state_hash);
}

TEST(ParticleSystemSPH, FieldsAreAsLongAsThereAreParticlesAtAnyTime) {
  // Who draws between steps reads State(), Density() and Pressure() side by side.
  for (const Integration integration :
       {Integration::kLeapFrog, Integration::kLeapFrogPublished, Integration::kSymplecticEuler}) {
    Parameters base = SmallBlock();
    base.integration = integration;
    ParticleSystemSPH system(base, Sph());
    const auto expect_same_length = [&](const char* when) {
      EXPECT_EQ(system.Density().size(), system.State().Size()) << when;
      EXPECT_EQ(system.Pressure().size(), system.State().Size()) << when;
    };
    system.Reset();
    expect_same_length("before the first step");
    system.Step();
    ASSERT_EQ(system.DropBlock(), "");
    expect_same_length("after a drop");
    system.Reset();
    expect_same_length("after a reset");
  }
}

TEST(ParticleSystemSPH, MeanNeighboursLeavesTheParticleItselfOut) {
  Cloud three;  // in a row, each a neighbour of the next
  three.x = {0, 1.5 * kCloudH, 3 * kCloudH};
  three.y = three.vx = three.vy = {0, 0, 0};
  three.mass = {1, 1, 1};
  EXPECT_DOUBLE_EQ(GivenSystem(NoForces(), Sph(), three).MeanNeighbours(), 4.0 / 3);
  EXPECT_EQ(GivenSystem(NoForces(), Sph(), Cloud{}).MeanNeighbours(), 0);
}

TEST(ParticleSystemSPH, ResetBringsBackTheSameBits) {
  ParticleSystemSPH system(SmallBlock(), Sph());
  system.Reset();
  const std::uint64_t start = Diagnose(system).state_hash;
  for (int k = 0; k < 10; ++k) system.Step();
  const std::uint64_t then = Diagnose(system).state_hash;
  system.DropBlock();
  system.parameters.motion_damping = 17;
  system.parameters_sph.equation_of_state = Polytrope{3};
  system.parameters_sph.viscosity = 5;
  system.Step();
  system.Reset();
  EXPECT_EQ(system.Time(), 0);
  EXPECT_EQ(Diagnose(system).state_hash, start);
  for (int k = 0; k < 10; ++k) system.Step();
  EXPECT_EQ(Diagnose(system).state_hash, then);
}

TEST(ParticleSystemSPH, InternalEnergyIsTheParticlesSum) {
  const Cloud cloud = AllClouds().back();
  const GivenSystem system(NoForces(), Sph(), cloud);
  double sum = 0;
  for (std::size_t i = 0; i < cloud.Size(); ++i)
    sum += system.State().mass[i] * kWater.InternalEnergy(system.Density()[i]);
  EXPECT_DOUBLE_EQ(system.InternalEnergy(), sum);
}

/// Four particles at rest, far from each other; the third one moves at `speed`.
Cloud OneMoves(double speed) {
  Cloud cloud;
  cloud.x = {0, 1, 2, 3};
  cloud.y = {0, 0, 0, 0};
  cloud.vx = {0, 0, speed, 0};
  cloud.vy = {0, 0, 0, 0};
  cloud.mass = {1, 1, 1, 1};
  return cloud;
}

TEST(ParticleSystemSPH, AMoveBeyondTheSupportIsReportedWithStepParticleAndLimit) {
  GivenSystem system(NoForces(), Sph(Polytrope{0.1}), OneMoves(200));  // 0.2 m a step; the support radius is 0.1 m
  system.Step();
  ASSERT_TRUE(system.Trouble());
  EXPECT_EQ(system.Trouble()->step, 1);
  EXPECT_DOUBLE_EQ(system.Trouble()->time, 1e-3);
  EXPECT_EQ(system.Trouble()->id, 2u);
  EXPECT_DOUBLE_EQ(system.Trouble()->velocity.x, 200);
  EXPECT_DOUBLE_EQ(system.Trouble()->position.x, 2.2);
  const std::string message = system.Trouble()->Message();
  for (const char* part : {"step 1", "particle 2", "support radius of 0.1 m", "below 0.0005 s"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
}

TEST(ParticleSystemSPH, AMoveWithinTheSupportIsNotReported) {
  GivenSystem system(NoForces(), Sph(Polytrope{0.1}), OneMoves(99.9));
  system.Step();
  EXPECT_FALSE(system.Trouble());
}

TEST(ParticleSystemSPH, AfterTroubleNothingMovesUntilReset) {
  GivenSystem system(NoForces(), Sph(Polytrope{0.1}), OneMoves(200));
  system.Step();
  const std::uint64_t stopped = Diagnose(system).state_hash;
  for (int k = 0; k < 3; ++k) system.Step();
  EXPECT_EQ(system.Steps(), 1);
  EXPECT_EQ(Diagnose(system).state_hash, stopped);
  system.Reset();
  EXPECT_FALSE(system.Trouble());
}

TEST(ParticleSystemSPH, VelocitiesThatAreNoNumbersAreReportedAndHarmNothingElse) {
  Parameters base = SmallBlock();
  base.central_force = -1e300;
  ParticleSystemSPH system(base, Sph());
  system.Reset();
  for (int k = 0; k < 5 && !system.Trouble(); ++k) {
    base = system.parameters;
    system.parameters.central_force *= 1e300;  // infinite: 0.4 m times 1e600
    system.Step();
  }
  ASSERT_TRUE(system.Trouble());
  EXPECT_NE(system.Trouble()->limit.find("not a number"), std::string::npos) << system.Trouble()->limit;
  system.ComputeFields();  // what a window does while it shows the message
  Diagnose(system);
  EXPECT_NE(system.DropBlock(), "");
}

}  // namespace
}  // namespace sph
