// The liquid's passes on vectors against the sums over all pairs.
#include "sph/delta_passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
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
  for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
    s.water.excess[i] = random.Uniform(-0.5, 0.5);
    s.water.pressure[i] = random.Uniform(-5, 10);
    s.water.gradient_x[i] = random.Uniform(-3, 3);
    s.water.gradient_y[i] = random.Uniform(-3, 3);
    s.water.wholeness[i] = random.Uniform(0, 1.2);
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

template <typename Real>
class DeltaPasses : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(DeltaPasses, BothPrecisions);

TYPED_TEST(DeltaPasses, RatesOfDensityEqualTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        WaterSetting<TypeParam> s(cloud);
        MakeRandom(s, kernel);
        s.ComputeRates();
        const auto plain = PlainDensityRates(s.cloud, s.water);
        for (std::size_t i = 0; i < cloud.Size(); ++i) {
          ASSERT_NEAR(s.rate[i], plain[i].value.x, kTolerance<TypeParam> * Scale(plain)) << cloud.name << ", " << i;
        }
      }
    }
  });
}

struct Terms {
  double viscosity, artificial;
  bool sharp, tensile;
};

TYPED_TEST(DeltaPasses, ForcesEqualTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        for (const Terms terms : {Terms{0, 0, false, true}, Terms{0, 0.3, false, true}, Terms{0.4, 0, true, false},
                                  Terms{0, 0, true, true}, Terms{0.4, 0.3, false, false}}) {
          WaterSetting<TypeParam> s(cloud);
          MakeRandom(s, kernel);
          s.water.viscosity = terms.viscosity;
          s.water.artificial = terms.artificial;
          s.water.sharp_gradient = terms.sharp;
          s.water.tensile_control = terms.tensile;
          s.ComputeForces();
          const auto plain = PlainWaterForces(s.cloud, s.water);
          const double round_off = kTolerance<TypeParam> * Scale(plain);
          for (std::size_t i = 0; i < cloud.Size(); ++i) {
            const double tolerance = round_off + BlurOfDirections(s, i);
            ASSERT_NEAR(s.ax[i], plain[i].value.x, tolerance) << cloud.name << ", " << i;
            ASSERT_NEAR(s.ay[i], plain[i].value.y, tolerance) << cloud.name << ", " << i;
          }
        }
      }
    }
  });
}

/// Where the particle at `of` stands against the thresholds of AddWaterForces.
struct Sides {
  bool known;           // has neighbours on all sides, so that a gradient is told
  bool shifted;         // is not at the surface
  bool at_surface;      // loses the part of the shift that leads outwards
  bool near_threshold;  // round-off decides one of these
};
Sides SidesOf(const PlainSurroundings& of, double tolerance) {
  constexpr double kFallInASupport = 0.2;
  const double steepness = Length(of.wholeness_gradient) * 2 * kCloudH;
  const double blur = 100 * tolerance * std::max(1.0, of.greatest);
  Sides sides{of.wholeness > 0.2, of.wholeness > 0.55, false, false};
  sides.at_surface = steepness > kFallInASupport && Dot(of.lack.value, of.wholeness_gradient) > 0;
  const double slope_blur = blur * (1 + of.fall.size * of.greatest * 2 * kCloudH);
  sides.near_threshold = std::abs(of.wholeness - 0.2) < blur || std::abs(of.wholeness - 0.55) < blur ||
                         std::abs(steepness - kFallInASupport) < slope_blur;
  return sides;
}

template <typename Real>
void ExpectSurroundingsOfTheTwin(const Cloud& cloud, SmoothingKernel kernel, int& known, int& at_surface) {
  WaterSetting<Real> s(cloud);
  MakeRandom(s, kernel);
  // Wholeness that falls to the right, so that some particles are near a surface.
  for (std::size_t i = 0; i < cloud.Size(); ++i) s.water.wholeness[i] = 1 - std::fmod(std::abs(3 * s.cloud.x[i]), 1.0);
  s.ComputeForces();
  const auto plain = SurroundingsOf(s.cloud, s.water);
  double greatest = 0;
  for (const PlainSurroundings& of : plain) greatest = std::max(greatest, of.greatest);
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    SCOPED_TRACE(cloud.name + ", " + std::to_string(i));
    const PlainSurroundings& of = plain[i];
    ASSERT_NEAR(s.wholeness[i], of.wholeness, 2 * kTolerance<Real> * greatest);
    const Sides sides = SidesOf(of, kTolerance<Real>);
    if (sides.near_threshold) continue;
    // A determinant knows its lesser eigenvalue to round-off of the greater one.
    const double condition = sides.known ? of.greatest / of.wholeness : 1;
    const double tolerance = 4 * kTolerance<Real> * condition;
    const double gradient_bound = tolerance * condition * (1 + of.rise.size / std::max(of.wholeness, 0.1));
    ASSERT_NEAR(s.gradient_x[i], sides.known ? of.gradient.x : 0, gradient_bound);
    ASSERT_NEAR(s.gradient_y[i], sides.known ? of.gradient.y : 0, gradient_bound);
    Vec2 shift = sides.shifted ? of.lack.value : Vec2{};
    const Vec2 n = of.wholeness_gradient;
    if (sides.shifted && sides.at_surface) shift = shift - (Dot(shift, n) / Dot(n, n)) * n;
    const double shift_bound =
        tolerance * condition * (1 + of.lack.size) * (1 + (sides.at_surface ? of.fall.size / Length(n) : 0));
    ASSERT_NEAR(s.shift_x[i], shift.x, shift_bound);
    ASSERT_NEAR(s.shift_y[i], shift.y, shift_bound);
    known += sides.known;
    at_surface += sides.shifted && sides.at_surface;
  }
}

TYPED_TEST(DeltaPasses, GradientsWholenessAndShiftsEqualThoseOfAllPairs) {
  WithEveryInstructionSet([] {
    int known = 0, at_surface = 0;
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        ExpectSurroundingsOfTheTwin<TypeParam>(cloud, kernel, known, at_surface);
      }
    }
    EXPECT_GT(known, 1000);  // or nothing was compared
    EXPECT_GT(at_surface, 100);
  });
}

}  // namespace
}  // namespace sph
