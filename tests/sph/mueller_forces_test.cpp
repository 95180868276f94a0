// The tutorial's forces, right and as published, against the sum over all pairs.
#include "sph/mueller_forces.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

struct Setting {
  explicit Setting(const Cloud& given) : found(FindNeighbours(given, kCloudH)), cloud(found.cloud) {
    Random random(11);
    for (std::size_t i = 0; i < cloud.Size(); ++i) {
      density.push_back(random.Uniform(0.5, 5));
      pressure.push_back(random.Uniform(-10, 10));
    }
    ax.assign(cloud.Size(), 0);
    ay.assign(cloud.Size(), 0);
  }
  Setting(const Setting&) = delete;  // `cloud` refers to `found`
  template <typename Slope>
  void Add(const Slope& slope, double mu) {
    const MuellerArrays arrays{cloud.x, cloud.y, cloud.vx, cloud.vy, cloud.mass, density, pressure, ax, ay};
    for (const NeighbourBlock& block : found.blocks)
      AddMuellerForces(block, slope, ViscosityKernel(kCloudH), mu, arrays);
  }

  Neighbourhood found;
  Cloud& cloud;
  std::vector<double> density, pressure, ax, ay;
};

void ExpectWithinRoundOff(const Setting& s, const std::vector<PlainSum>& plain) {
  for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
    ASSERT_NEAR(s.ax[i], plain[i].value.x, plain[i].RoundOff()) << s.cloud.name << ", particle " << i;
    ASSERT_NEAR(s.ay[i], plain[i].value.y, plain[i].RoundOff()) << s.cloud.name << ", particle " << i;
  }
}

TEST(MuellerForces, EqualTheSumOverAllPairs) {
  for (const double mu : {0.0, 0.3}) {
    for (const Cloud& given : AllClouds()) {
      Setting s(given);
      s.Add(SpikySlope(kCloudH), mu);
      ExpectWithinRoundOff(s, PlainMuellerForces(s.cloud, s.density, s.pressure, kCloudH, mu, false));
    }
  }
}

TEST(MuellerForces, AsPublishedEqualTheTutorialsSumOverAllPairs) {
  for (const double mu : {0.0, 0.3}) {
    for (const Cloud& given : AllClouds()) {
      Setting s(given);
      s.Add(PublishedSpikySlope(kCloudH), mu);
      ExpectWithinRoundOff(s, PlainMuellerForces(s.cloud, s.density, s.pressure, kCloudH, mu, true));
    }
  }
}

TEST(MuellerForces, ConserveLinearMomentum) {
  constexpr double kMu = 0.3;
  for (const Cloud& given : AllClouds()) {
    Setting s(given);
    s.Add(SpikySlope(kCloudH), kMu);
    const auto plain = PlainMuellerForces(s.cloud, s.density, s.pressure, kCloudH, kMu, false);
    double fx = 0, fy = 0, bound = 0;
    for (std::size_t i = 0; i < given.Size(); ++i) {
      fx += s.cloud.mass[i] * s.ax[i];
      fy += s.cloud.mass[i] * s.ay[i];
      // Each acceleration is exact to its round-off, and as many of them are added as there are particles.
      bound += s.cloud.mass[i] * (plain[i].RoundOff() + static_cast<double>(given.Size()) * 2.3e-16 * plain[i].size);
    }
    EXPECT_LE(std::abs(fx), bound) << given.name;
    EXPECT_LE(std::abs(fy), bound) << given.name;
  }
}

/// Two particles of equal mass and density, 0.3 h apart on the x axis, the second one moving.
Cloud Pair(Vec2 velocity_of_second) {
  Cloud pair;
  pair.x = {0, 0.3 * kCloudH};
  pair.y = {0, 0};
  pair.vx = {0, velocity_of_second.x};
  pair.vy = {0, velocity_of_second.y};
  pair.mass = {1, 1};
  return pair;
}

TEST(MuellerForces, PressureRepelsAndTensionAttracts) {
  for (const double pressure : {2.0, -2.0}) {
    Setting s(Pair({}));
    s.density = {1, 1};
    s.pressure = {pressure, pressure};
    s.Add(SpikySlope(kCloudH), 0);
    EXPECT_GT(s.ax[1] * pressure, 0);
    EXPECT_DOUBLE_EQ(s.ax[0], -s.ax[1]);
  }
}

TEST(MuellerForces, AsPublishedRepelByNegativePressure) {
  Setting s(Pair({}));
  s.density = {1, 1};
  s.pressure = {-2, -2};
  s.Add(PublishedSpikySlope(kCloudH), 0);
  EXPECT_GT(s.ax[1], 0);
}

TEST(MuellerForces, ViscosityPullsVelocitiesTogetherAndTakesEnergy) {
  Setting s(Pair({0.4, -1.0}));
  s.density = {1, 1};
  s.pressure = {0, 0};
  s.Add(SpikySlope(kCloudH), 0.5);
  const double power = s.ax[1] * 0.4 + s.ay[1] * -1.0;  // the other particle is at rest
  EXPECT_LT(power, 0);
  EXPECT_DOUBLE_EQ(s.ax[0], -s.ax[1]);  // equal masses and densities: momentum is conserved
  EXPECT_DOUBLE_EQ(s.ay[0], -s.ay[1]);
  EXPECT_DOUBLE_EQ(s.ay[1] / s.ax[1], -1.0 / 0.4);
}

TEST(MuellerForces, ARigidTranslationIsNotViscous) {
  for (const Cloud& given : AllClouds()) {
    Setting s(given);
    s.cloud.vx.assign(given.Size(), 3);
    s.cloud.vy.assign(given.Size(), -2);
    Setting without(given);
    s.Add(SpikySlope(kCloudH), 5);
    without.Add(SpikySlope(kCloudH), 0);
    EXPECT_EQ(s.ax, without.ax) << given.name;
    EXPECT_EQ(s.ay, without.ay) << given.name;
  }
}

}  // namespace
}  // namespace sph
