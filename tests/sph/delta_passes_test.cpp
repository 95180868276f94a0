// The liquid's passes on vectors against the sums over all pairs.
#include "sph/delta_passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "sph/kernels.hpp"
#include "sph/water_setting.hpp"

namespace sph {
namespace {

/// All terms, with values that have nothing to do with the positions.
template <typename Real>
void MakeRandom(WaterSetting<Real>& s, SmoothingKernel kernel) {
  Random random(13);
  s.water.kernel = kernel;
  s.water.rho0 = 2;
  s.water.diffusion = 0.7;
  s.water.sound = 3;
  for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
    s.water.excess[i] = random.Uniform(-0.5, 0.5);
    s.water.pressure[i] = random.Uniform(-5, 10);
    s.water.gradient_x[i] = random.Uniform(-3, 3);
    s.water.gradient_y[i] = random.Uniform(-3, 3);
    s.water.wholeness[i] = random.Uniform(0, 1.2);
    s.water.strain[i] = random.Uniform(0, 0.04 * s.water.sound / (2 * kCloudH));
  }
}

/// The sizes of the terms are the scale: sums of terms of both signs may be much smaller than what was added.
double Scale(const std::vector<PlainSum>& sums) {
  double greatest = 0;
  for (const PlainSum& sum : sums) greatest = std::max(greatest, sum.size);
  return greatest;
}

/// By how much artificial viscosity may differ because it depends on directions, which a float position knows only to
/// its unit over the distance.
template <typename Real>
double BlurOfDirections(const WaterSetting<Real>& s, std::size_t i) {
  if (sizeof(Real) == 8 || s.water.artificial == 0) return 0;
  const double unit = Positions<Real>::Unit(2 * kCloudH);
  const double h = s.water.h;
  const double steepest = -GradientAt(s.water.kernel, h, 0);
  double sum = 0;
  for (std::size_t j = 0; j < s.cloud.Size(); ++j) {
    const double r = std::hypot(s.cloud.x[i] - s.cloud.x[j], s.cloud.y[i] - s.cloud.y[j]);
    if (r == 0 || r > 2 * h) continue;
    const double speed = std::hypot(s.cloud.vx[i] - s.cloud.vx[j], s.cloud.vy[i] - s.cloud.vy[j]);
    const double term =
        s.water.artificial * s.cloud.mass[j] / (s.water.Density(i) * s.water.Density(j)) * steepest * speed;
    sum += term * std::min(2.0, 2 * unit / r);  // both factors of r^ (r^.du) turn; each end is rounded by half a unit
  }
  return sum;
}

/// By how much the drag may differ: its weights are sums of up to 8 3^6 that cancel each other where particles are
/// close, over q = r/(h/2), a 64th at least.
template <typename Real>
double BlurOfDrag(const WaterSetting<Real>& s, std::size_t i) {
  const double h = 0.5 * s.water.h;
  const double factor = 7 * SepticSpline::kNormalisation / std::pow(h, 4) * SepticSpline::kFlat;
  double sum = 0;
  for (std::size_t j = 0; j < s.cloud.Size(); ++j) {
    const double q = std::hypot(s.cloud.x[i] - s.cloud.x[j], s.cloud.y[i] - s.cloud.y[j]) / h;
    const double speed = std::hypot(s.cloud.vx[i] - s.cloud.vx[j], s.cloud.vy[i] - s.cloud.vy[j]);
    const double volume = s.cloud.mass[j] / s.water.Density(j);
    if (q < 1) sum += volume * speed * std::min(1 / q, 64.0);
  }
  const double round_off = kTolerance<Real> / 8;  // of the few operations of a term
  return 2 * s.water.viscosity / s.water.Density(i) * factor * 8 * std::pow(3, 6) * round_off * sum;
}

template <typename Real>
class DeltaPasses : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(DeltaPasses, BothPrecisions);

/// Where the divergence is renormalised, determinants know it to round-off of the greater eigenvalue over the lesser.
template <typename Real>
void ExpectRatesOfTheTwin(const Cloud& cloud, SmoothingKernel kernel, int& inside) {
  WaterSetting<Real> s(cloud);
  MakeRandom(s, kernel);
  s.ComputeRates();
  const auto plain = PlainDensityRates(s.cloud, s.water);
  double scale = 0, fastest = 0;
  for (const PlainRates& of : plain) {
    scale = std::max(scale, of.rate.size);
    fastest = std::max(fastest, of.strain);
  }
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    const PlainRates& of = plain[i];
    SCOPED_TRACE(cloud.name + ", " + std::to_string(i));
    ASSERT_NEAR(s.strain[i], of.strain, 2 * kTolerance<Real> * fastest);
    if (std::abs(of.wholeness - 0.75) < 100 * kTolerance<Real> * of.greatest) continue;  // round-off decides
    const bool renormalised = of.wholeness > 0.75;
    const double condition = renormalised ? 4 * std::pow(of.greatest / of.wholeness, 2) : 1;
    ASSERT_NEAR(s.rate[i], of.rate.value.x, kTolerance<Real> * condition * scale);
    inside += renormalised;
  }
}

TYPED_TEST(DeltaPasses, RatesOfDensityAndStrainsEqualTheSumsOverAllPairs) {
  WithEveryInstructionSet([] {
    int inside = 0;
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) ExpectRatesOfTheTwin<TypeParam>(cloud, kernel, inside);
    }
    EXPECT_GT(inside, 1000);  // or the divergence was renormalised nowhere
  });
}

struct Terms {
  double viscosity, artificial, flat, fall;
  bool tensile;
};

TYPED_TEST(DeltaPasses, ForcesEqualTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        for (const Terms terms :
             {Terms{0, 0, 1.02, 0, true}, Terms{0, 0.3, 1.02, 0, true}, Terms{0.4, 0, 3.5, 11, false},
              Terms{0, 0, 3.5, 11, true}, Terms{0.4, 0.3, 1.02, 0, false}, Terms{0.4, 0.3, 3.5, 11, true}}) {
          WaterSetting<TypeParam> s(cloud);
          MakeRandom(s, kernel);
          s.water.viscosity = terms.viscosity;
          s.water.artificial = terms.artificial;
          s.water.gradient_flat = terms.flat;
          s.water.gradient_fall = terms.fall;
          s.water.tensile_control = terms.tensile;
          s.ComputeForces();
          const auto plain = PlainWaterForces(s.cloud, s.water);
          const double round_off = kTolerance<TypeParam> * Scale(plain);
          for (std::size_t i = 0; i < cloud.Size(); ++i) {
            const double tolerance = round_off + BlurOfDirections(s, i) + BlurOfDrag(s, i);
            ASSERT_NEAR(s.ax[i], plain[i].value.x, tolerance) << cloud.name << ", " << i;
            ASSERT_NEAR(s.ay[i], plain[i].value.y, tolerance) << cloud.name << ", " << i;
          }
        }
      }
    }
  });
}

/// Where a particle stands against the thresholds of AddWaterForces.
struct Sides {
  bool known;           // has neighbours on all sides, so that a gradient is told
  bool steep;           // its wholeness falls as it does beside a surface
  bool at_surface;      // loses the outward part of the shift, but for that of close pairs
  bool near_threshold;  // round-off decides one of these
  Vec2 shift;
};
/// @param restless  the relative speeds over a support as a part of sound's
Sides SidesOf(const PlainSurroundings& of, double restless, double tolerance) {
  constexpr double kFallInASupport = 0.2;
  const double steepness = Length(of.wholeness_gradient) * 2 * kCloudH;
  const double blur = 100 * tolerance * std::max(1.0, of.greatest);
  const double apart = 2 * std::min(1.0, of.wholeness / 0.55) * std::min(1.0, restless / 0.02);
  Sides sides{of.wholeness > 0.2, false, false, false, apart * of.near.value};
  const Vec2 n = of.wholeness_gradient;
  Vec2 lack = of.lack.value;
  sides.steep = sides.known && steepness > kFallInASupport;
  sides.at_surface = sides.steep && Dot(lack, n) > 0;
  if (sides.at_surface) lack = lack - (Dot(lack, n) / Dot(n, n)) * n;
  if (of.wholeness > 0.55) sides.shift = sides.shift + lack;
  const double slope_blur = blur * (1 + of.fall.size * of.greatest * 2 * kCloudH);
  sides.near_threshold = std::abs(of.wholeness - 0.2) < blur || std::abs(of.wholeness - 0.55) < blur ||
                         (sides.known && std::abs(steepness - kFallInASupport) < slope_blur);
  return sides;
}

/// How often what is rare was met.
struct Met {
  int known = 0, at_surface = 0, crowded = 0, steep = 0;
};

template <typename Real>
void ExpectSurroundingsOfTheTwin(const Cloud& cloud, SmoothingKernel kernel, Met& met) {
  WaterSetting<Real> s(cloud);
  MakeRandom(s, kernel);
  // Wholeness that falls to the right, so that some particles are near a surface.
  for (std::size_t i = 0; i < cloud.Size(); ++i) s.water.wholeness[i] = 1 - std::fmod(std::abs(3 * s.cloud.x[i]), 1.0);
  s.ComputeForces();
  const auto plain = SurroundingsOf(s.cloud, s.water);
  double greatest = 0, densest = 0;
  for (const PlainSurroundings& of : plain) {
    greatest = std::max(greatest, of.greatest);
    densest = std::max(densest, of.concentration);
  }
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    SCOPED_TRACE(cloud.name + ", " + std::to_string(i));
    const PlainSurroundings& of = plain[i];
    ASSERT_NEAR(s.wholeness[i], of.wholeness, 2 * kTolerance<Real> * greatest);
    const Sides sides = SidesOf(of, s.water.strain[i] * 2 * kCloudH / s.water.sound, kTolerance<Real>);
    if (sides.near_threshold) continue;
    ASSERT_NEAR(s.concentration[i], sides.steep ? 0 : of.concentration, kTolerance<Real> * densest);
    // A determinant knows its lesser eigenvalue to round-off of the greater one.
    const double condition = sides.known ? of.greatest / of.wholeness : 1;
    const double tolerance = 4 * kTolerance<Real> * condition;
    const double gradient_bound = tolerance * condition * (1 + of.rise.size / std::max(of.wholeness, 0.1));
    ASSERT_NEAR(s.gradient_x[i], sides.known ? of.gradient.x : 0, gradient_bound);
    ASSERT_NEAR(s.gradient_y[i], sides.known ? of.gradient.y : 0, gradient_bound);
    const double of_normal = sides.at_surface ? of.fall.size / Length(of.wholeness_gradient) : 0;
    const double shift_bound = tolerance * condition * (1 + of.lack.size + 3 * of.near.size) * (1 + of_normal);
    ASSERT_NEAR(s.shift_x[i], sides.shift.x, shift_bound);
    ASSERT_NEAR(s.shift_y[i], sides.shift.y, shift_bound);
    met.known += sides.known;
    met.at_surface += sides.at_surface;
    met.crowded += of.near.size > 0.1 * of.lack.size;
    met.steep += sides.steep;
  }
}

TYPED_TEST(DeltaPasses, WhatParticlesKnowOfTheirSurroundingsEqualsThatOfAllPairs) {
  WithEveryInstructionSet([] {
    Met met;
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) ExpectSurroundingsOfTheTwin<TypeParam>(cloud, kernel, met);
    }
    EXPECT_GT(met.known, 1000);  // or nothing was compared
    EXPECT_GT(met.at_surface, 100);
    EXPECT_GT(met.crowded, 100);
    EXPECT_GT(met.steep, 100);
  });
}

}  // namespace
}  // namespace sph
