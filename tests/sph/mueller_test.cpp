// The tutorial's solver as a whole, right and as published.
#include "sph/mueller.hpp"

#include <gtest/gtest.h>

#include "sph/given_system.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

constexpr double kMu = 0.4;
const IdealGas kGas{2.0, 1.0};

/// 300 particles at random, so that densities and pressures are all different.
struct Fluid {
  Fluid(bool published, Vec2 gravity) : system(Base(gravity), {2 * kCloudH, kGas, kMu, published}) { system.Reset(); }

  static Parameters Base(Vec2 gravity) {
    Parameters base = NoForces();
    base.fluid.particles = 300;
    base.fluid.region.box = {-0.4, 0, 0.4, 0.5};
    base.particle_mass = 0.4 / 300;
    base.gravity = gravity;
    base.integration = Integration::kSymplecticEuler;
    return base;
  }

  Mueller system;
};

TEST(Mueller, DensityIsPoly6sSumOverAllPairs) {
  Fluid fluid(false, {});
  fluid.system.ComputeFields();
  const auto plain = PlainPoly6Density(CloudOf(fluid.system), 2 * kCloudH);
  for (std::size_t i = 0; i < 300; ++i) {
    ASSERT_NEAR(fluid.system.Density()[i], plain[i].value.x, plain[i].RoundOff());
    ASSERT_EQ(fluid.system.Pressure()[i], kGas.Pressure(fluid.system.Density()[i]));
  }
}

TEST(Mueller, AccelerationIsForcesAndGravityRightAndAsPublished) {
  const Vec2 g{1, -10};
  for (const bool published : {false, true}) {
    Fluid fluid(published, g);
    for (int k = 0; k < 5; ++k) fluid.system.Step();  // for velocities that differ
    fluid.system.ComputeFields();
    const Particles& p = fluid.system.State();
    const auto density = fluid.system.Density();
    const auto plain =
        PlainMuellerForces(CloudOf(fluid.system), density, fluid.system.Pressure(), 2 * kCloudH, kMu, published);
    for (std::size_t i = 0; i < p.Size(); ++i) {
      // The tutorial multiplies gravity by m/rho, and divides the sum of all forces by rho.
      const double share = published ? p.mass[i] / density[i] / density[i] : 1;
      const double round_off = plain[i].RoundOff() + 1e-14 * (1 + share);  // of adding gravity
      ASSERT_NEAR(p.ax[i], plain[i].value.x + share * g.x, round_off) << published;
      ASSERT_NEAR(p.ay[i], plain[i].value.y + share * g.y, round_off) << published;
    }
  }
}

TEST(Mueller, RightlyALoneParticleFallsWithGravity) {
  Parameters base = NoForces();
  base.gravity = {0, -10};
  Mueller system(base, {0.16, kGas, kMu, false});
  system.Reset();
  system.ComputeFields();
  EXPECT_EQ(system.State().ax[0], 0);
  EXPECT_EQ(system.State().ay[0], -10);
}

TEST(Mueller, SupportIsTheSmoothingLengthItself) {
  const Mueller system(NoForces(), {0.16, kGas, kMu, false});
  EXPECT_EQ(system.Support(), 0.16);
}

TEST(Mueller, PlanSaysThatViscosityIsLeftOutWhenItIsZero) {
  const auto reason = [](double mu) {
    for (const PassPlan& pass : Mueller(NoForces(), {0.16, kGas, mu, false}).Plan()) {
      if (pass.name == "pressure") return pass.reason;
    }
    return std::string();
  };
  EXPECT_NE(reason(0).find("left out"), std::string::npos);
  EXPECT_EQ(reason(1).find("left out"), std::string::npos);
  EXPECT_NE(reason(1), "");
}

}  // namespace
}  // namespace sph
