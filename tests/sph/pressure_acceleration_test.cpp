// Pressure acceleration against the sum over all pairs, and what its symmetry conserves.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "sph/cluster_passes.hpp"
#include "sph/kernels.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

/// A cloud with densities and pressures that have nothing to do with its positions: of both signs, and all different.
template <typename Real>
struct Setting {
  explicit Setting(const Cloud& given) : found(FindNeighbours<Real>(given, 2 * kCloudH)), cloud(found.cloud) {
    Random random(7);
    for (std::size_t i = 0; i < cloud.Size(); ++i) {
      density.push_back(random.Uniform(0.5, 5));
      pressure.push_back(random.Uniform(-1, 10));
      term.push_back(static_cast<Real>(pressure[i] / (density[i] * density[i])));
    }
    term.resize(cloud.Size() + kPadding);
    ax.assign(cloud.Size(), 0);
    ay.assign(cloud.Size(), 0);
  }
  Setting(const Setting&) = delete;  // `cloud` refers to `found`
  void Add() {
    for (const ListBlock& block : found.search.Blocks()) {
      AddCubicSplinePressure(found.Input(), block, term.data(), ax.data(), ay.data());
    }
  }

  Neighbourhood<Real> found;
  Cloud& cloud;
  std::vector<double> density, pressure, ax, ay;
  std::vector<Real> term;
};

template <typename Real>
class PressureAccelerationOf : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(PressureAccelerationOf, BothPrecisions);

TYPED_TEST(PressureAccelerationOf, EqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& given : AllClouds()) {
      Setting<TypeParam> s(given);
      s.Add();
      const auto plain = PlainPressureAcceleration(s.cloud, s.density, s.pressure, kCloudH);
      double greatest = 0;
      for (const PlainSum& sum : plain) greatest = std::max(greatest, Length(sum.value));
      for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
        ASSERT_NEAR(s.ax[i], plain[i].value.x, kTolerance<TypeParam> * greatest) << given.name << ", particle " << i;
        ASSERT_NEAR(s.ay[i], plain[i].value.y, kTolerance<TypeParam> * greatest) << given.name << ", particle " << i;
      }
    }
  });
}

TEST(PressureAcceleration, IsAddedToWhatIsThere) {
  for (const Cloud& given : AllClouds()) {
    Setting<double> from_zero(given), from_one(given);
    from_zero.Add();
    from_one.ax.assign(given.Size(), 1);
    from_one.Add();
    for (std::size_t i = 0; i < given.Size(); ++i) ASSERT_EQ(from_one.ax[i], 1 + from_zero.ax[i]) << given.name;
  }
}

TEST(PressureAcceleration, ConservesLinearAndAngularMomentum) {
  for (const Cloud& given : AllClouds()) {
    Setting<double> s(given);
    s.Add();
    const auto plain = PlainPressureAcceleration(s.cloud, s.density, s.pressure, kCloudH);
    double fx = 0, fy = 0, torque = 0, force_bound = 0, torque_bound = 0;
    for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
      const double m = s.cloud.mass[i];
      fx += m * s.ax[i];
      fy += m * s.ay[i];
      torque += m * (s.cloud.x[i] * s.ay[i] - s.cloud.y[i] * s.ax[i]);
      // Each acceleration is exact to its round-off, and as many of them are added as there are particles.
      const double bound = m * (plain[i].RoundOff() + static_cast<double>(given.Size()) * 2.3e-16 * plain[i].size);
      force_bound += bound;
      torque_bound += 2 * bound * (std::abs(s.cloud.x[i]) + std::abs(s.cloud.y[i]));
    }
    EXPECT_LE(std::abs(fx), force_bound) << given.name;
    EXPECT_LE(std::abs(fy), force_bound) << given.name;
    EXPECT_LE(std::abs(torque), torque_bound) << given.name;
  }
}

TEST(PressureAcceleration, PushesTwoParticlesApartAlongTheirLine) {
  Cloud pair;
  pair.x = {0, 0.03};
  pair.y = {0, 0.04};
  pair.vx = pair.vy = {0, 0};
  pair.mass = {1, 3};
  Setting<double> s(pair);
  s.term[0] = s.term[1] = 2;
  s.Add();
  EXPECT_LT(s.ax[0], 0);
  EXPECT_DOUBLE_EQ(s.ay[0] / s.ax[0], 4.0 / 3);
  EXPECT_DOUBLE_EQ(s.ax[0], -3 * s.ax[1]);  // action and reaction: masses 1 and 3
}

TEST(PressureAcceleration, IsZeroBetweenCoincidentParticles) {
  Cloud pair;
  pair.x = pair.y = pair.vx = pair.vy = {0.5, 0.5};
  pair.mass = {1, 1};
  Setting<double> s(pair);
  s.Add();
  EXPECT_EQ(s.ax[0], 0);
  EXPECT_EQ(s.ay[1], 0);
}

TEST(PressureAcceleration, IsThatOfTheExactPairPotentialForATwoParticleGas) {
  // With P = k rho^2 eq. 10 is 2k sum m_j grad W_ij, the gradient of H = k sum_ij m_i m_j W_ij: differences of H give
  // the force.
  constexpr double kGas = 0.1;
  const double m[2] = {0.5, 1.5};
  const CubicSpline<2> kernel(kCloudH);
  const auto potential = [&](double distance) { return 2 * kGas * m[0] * m[1] * kernel.Value(distance); };
  for (const double r : {0.3 * kCloudH, 0.9 * kCloudH, 1.7 * kCloudH}) {
    Cloud pair;
    pair.x = {0, r};
    pair.y = pair.vx = pair.vy = {0, 0};
    pair.mass = {m[0], m[1]};
    Setting<double> s(pair);
    s.term[0] = s.term[1] = kGas;
    s.Add();
    const double delta = 1e-5 * kCloudH;
    const double force_on_second = -(potential(r + delta) - potential(r - delta)) / (2 * delta);
    EXPECT_NEAR(m[1] * s.ax[1], force_on_second, 1e-9 * potential(0) / kCloudH)
        << r;  // the difference's error, as in kernels_test
  }
}

}  // namespace
}  // namespace sph
