// How errors of the accurate solver's sums fall with the spacing at a fixed h/dx: on lattices and on particles in
// disorder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "sph/water_setting.hpp"

namespace sph {
namespace {

constexpr double kDx = kCloudH / 2;  // [m]: h = 2 dx
constexpr int kRim = 5;              // spacings; the support is 4 of them

/// A strip one wave of `per_wave` spacings long, and a rim, moved by up to `jitter` spacings.
Cloud Strip(int per_wave, double jitter) {
  Random random(3);
  Cloud cloud;
  cloud.name = "strip";
  for (int row = 0; row < 2 * kRim + 3; ++row) {
    for (int column = 0; column < per_wave + 2 * kRim; ++column) {
      cloud.x.push_back((column - kRim + random.Uniform(-jitter, jitter)) * kDx);
      cloud.y.push_back((row - kRim + random.Uniform(-jitter, jitter)) * kDx);
    }
  }
  cloud.vx.assign(cloud.Size(), 0);
  cloud.vy.assign(cloud.Size(), 0);
  cloud.mass.assign(cloud.Size(), kDx * kDx);
  return cloud;
}

/// Root mean square of computed - exact over that of exact, away from the rim.
class Errors {
 public:
  Errors(const Cloud& cloud, int per_wave) : cloud_(cloud), length_(per_wave * kDx) {}
  template <typename Computed, typename Exact>
  double Of(Computed computed, Exact exact) const {
    double squares = 0, exact_squares = 0;
    for (std::size_t i = 0; i < cloud_.Size(); ++i) {
      if (cloud_.x[i] < 0 || cloud_.x[i] >= length_ || std::abs(cloud_.y[i] - kDx) > 1.5 * kDx) continue;
      const double phase = 2 * std::numbers::pi * cloud_.x[i] / length_;
      squares += std::pow(computed(i) - exact(phase), 2);
      exact_squares += std::pow(exact(phase), 2);
    }
    return std::sqrt(squares / exact_squares);
  }

 private:
  const Cloud& cloud_;
  double length_;
};

/// Of sum_j m_j f_j W, masses being those of unit density times f = 2 + sin kx: interpolation of f.
double InterpolationError(int per_wave, double jitter) {
  Cloud cloud = Strip(per_wave, jitter);
  const double k = 2 * std::numbers::pi / (per_wave * kDx);
  for (std::size_t i = 0; i < cloud.Size(); ++i) cloud.mass[i] *= 2 + std::sin(k * cloud.x[i]);
  auto found = FindNeighbours<double>(cloud, 2 * kCloudH);
  std::vector<double> density(cloud.Size() + kPadding);
  for (ListBlock& block : found.search.Blocks()) {
    ComputeGasDensity(SmoothingKernel::kWendlandC2, found.Input(), block, density.data());
  }
  return Errors(found.cloud, per_wave)
      .Of([&](std::size_t i) { return density[i]; }, [](double phase) { return 2 + std::sin(phase); });
}

/// Of the renormalised gradient of an excess density of sin kx.
double GradientError(int per_wave, double jitter) {
  WaterSetting<double> s(Strip(per_wave, jitter));
  const double k = 2 * std::numbers::pi / (per_wave * kDx);
  for (std::size_t i = 0; i < s.cloud.Size(); ++i) s.water.excess[i] = 1e-6 * std::sin(k * s.cloud.x[i]);
  s.ComputeForces();
  return Errors(s.cloud, per_wave)
      .Of([&](std::size_t i) { return s.gradient_x[i]; }, [&](double phase) { return 1e-6 * k * std::cos(phase); });
}

/// d log(error)/d log(dx) from 16 to 32 and from 32 to 64 spacings a wave, the lesser.
double Order(double (*error)(int, double), double jitter) {
  const double coarse = error(16, jitter), middle = error(32, jitter), fine = error(64, jitter);
  return std::min(std::log2(coarse / middle), std::log2(middle / fine));
}

TEST(DeltaOrders, InterpolationIsOfSecondOrderOnALattice) {
  // Until the lattice's own error, 1.2e-3 for h = 2 dx, shows.
  EXPECT_GT(std::log2(InterpolationError(8, 0) / InterpolationError(16, 0)), 1.8);
  EXPECT_LT(InterpolationError(64, 0), 2e-3);
}

TEST(DeltaOrders, InterpolationOnParticlesInDisorderStopsAtWhatTheirDisorderLeaves) {
  EXPECT_GT(InterpolationError(64, 0.1), 2 * InterpolationError(64, 0));
  EXPECT_NEAR(InterpolationError(64, 0.1) / InterpolationError(128, 0.1), 1, 0.3);
}

TEST(DeltaOrders, RenormalisedGradientIsOfSecondOrderOnALatticeAndInDisorder) {
  EXPECT_GT(Order(GradientError, 0), 1.85);
  EXPECT_GT(Order(GradientError, 0.1), 1.7);
}

}  // namespace
}  // namespace sph
