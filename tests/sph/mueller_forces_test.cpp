// The tutorial's forces, right and as published, against the sum over all pairs.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "sph/cluster_passes.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

constexpr bool kRight = false;
constexpr bool kPublished = true;

template <typename Real>
struct Setting {
  explicit Setting(const Cloud& given) : found(FindNeighbours<Real>(given, kCloudH)), cloud(found.cloud) {
    Random random(11);
    for (std::size_t i = 0; i < cloud.Size(); ++i) {
      density.push_back(random.Uniform(0.5, 5));
      pressure.push_back(random.Uniform(-10, 10));
    }
    ax.assign(cloud.Size(), 0);
    ay.assign(cloud.Size(), 0);
  }
  Setting(const Setting&) = delete;  // `cloud` refers to `found`
  void Add(bool published, double mu) {
    const auto converted = [](const std::vector<double>& values) {
      std::vector<Real> to(values.begin(), values.end());
      to.resize(values.size() + kPadding);
      return to;
    };
    std::vector<double> volume = cloud.mass;
    for (std::size_t i = 0; i < cloud.Size(); ++i) volume[i] /= density[i];
    const auto volumes = converted(volume), pressures = converted(pressure), densities = converted(density),
               vx = converted(cloud.vx), vy = converted(cloud.vy);
    const MuellerInput<Real> input{volumes.data(), pressures.data(), densities.data(), vx.data(), vy.data(), mu,
                                   published};
    for (const ListBlock& block : found.search.Blocks()) {
      AddMuellerForces(found.Input(), input, block, ax.data(), ay.data());
    }
  }

  Neighbourhood<Real> found;
  Cloud& cloud;
  std::vector<double> density, pressure, ax, ay;
};

/// Spiky's slope does not vanish at r = 0, so the force between two particles almost in one place turns with their
/// direction, of which float positions know only support/2^28 over r.
template <typename Real>
constexpr double kNearContact = sizeof(Real) == 4 ? 20 * kTolerance<float> : kTolerance<double>;

template <typename Real>
class MuellerForcesOf : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(MuellerForcesOf, BothPrecisions);

template <typename Real>
void ExpectTwinsAgree(bool published) {
  WithEveryInstructionSet([&] {
    for (const double mu : {0.0, 0.3}) {
      for (const Cloud& given : AllClouds()) {
        Setting<Real> s(given);
        s.Add(published, mu);
        const auto plain = PlainMuellerForces(s.cloud, s.density, s.pressure, kCloudH, mu, published);
        double greatest = 0;
        for (const PlainSum& sum : plain) greatest = std::max(greatest, Length(sum.value));
        for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
          ASSERT_NEAR(s.ax[i], plain[i].value.x, kNearContact<Real> * greatest) << given.name << ", particle " << i;
          ASSERT_NEAR(s.ay[i], plain[i].value.y, kNearContact<Real> * greatest) << given.name << ", particle " << i;
        }
      }
    }
  });
}

TYPED_TEST(MuellerForcesOf, EqualTheSumOverAllPairs) { ExpectTwinsAgree<TypeParam>(kRight); }

TYPED_TEST(MuellerForcesOf, AsPublishedEqualTheTutorialsSumOverAllPairs) { ExpectTwinsAgree<TypeParam>(kPublished); }

TEST(MuellerForces, ConserveLinearMomentum) {
  constexpr double kMu = 0.3;
  for (const Cloud& given : AllClouds()) {
    Setting<double> s(given);
    s.Add(kRight, kMu);
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
    Setting<double> s(Pair({}));
    s.density = {1, 1};
    s.pressure = {pressure, pressure};
    s.Add(kRight, 0);
    EXPECT_GT(s.ax[1] * pressure, 0);
    EXPECT_DOUBLE_EQ(s.ax[0], -s.ax[1]);
  }
}

TEST(MuellerForces, AsPublishedRepelByNegativePressure) {
  Setting<double> s(Pair({}));
  s.density = {1, 1};
  s.pressure = {-2, -2};
  s.Add(kPublished, 0);
  EXPECT_GT(s.ax[1], 0);
}

TEST(MuellerForces, ViscosityPullsVelocitiesTogetherAndTakesEnergy) {
  Setting<double> s(Pair({0.4, -1.0}));
  s.density = {1, 1};
  s.pressure = {0, 0};
  s.Add(kRight, 0.5);
  const double power = s.ax[1] * 0.4 + s.ay[1] * -1.0;  // the other particle is at rest
  EXPECT_LT(power, 0);
  EXPECT_DOUBLE_EQ(s.ax[0], -s.ax[1]);  // equal masses and densities: momentum is conserved
  EXPECT_DOUBLE_EQ(s.ay[0], -s.ay[1]);
  EXPECT_DOUBLE_EQ(s.ay[1] / s.ax[1], -1.0 / 0.4);
}

TEST(MuellerForces, ARigidTranslationIsNotViscous) {
  for (const Cloud& given : AllClouds()) {
    Setting<double> s(given);
    s.cloud.vx.assign(given.Size(), 3);
    s.cloud.vy.assign(given.Size(), -2);
    Setting<double> without(given);
    s.Add(kRight, 5);
    without.Add(kRight, 0);
    EXPECT_EQ(s.ax, without.ax) << given.name;
    EXPECT_EQ(s.ay, without.ay) << given.name;
  }
}

}  // namespace
}  // namespace sph
