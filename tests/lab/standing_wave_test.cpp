// The standing wave's exact decay and frequency, and how they are read off an oscillation.
#include "lab/standing_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "lab/reference_data.hpp"

namespace sph {
namespace {

using std::numbers::pi;

TEST(StandingWave, DecaysAndSwingsAsTheTableSays) {
  // The table was confirmed by the eigenvalues of the linearised Navier-Stokes equations on Chebyshev polynomials.
  for (const auto& row : ReadReferenceRows("standing_wave_dispersion", 6)) {
    const auto root = StandingWave{pi, 1, row[1], 1}.Root();
    EXPECT_NEAR(root.real(), -row[4], 1e-9) << "Re = " << row[0];
    EXPECT_NEAR(root.imag(), row[5], 1e-9) << "Re = " << row[0];
  }
}

TEST(StandingWave, ScalesWithItsUnits) {
  // Lengths times 3 and g times 5 make times sqrt(3/5) as long; nu is length^2/time.
  const double time = std::sqrt(3.0 / 5);
  const auto root = StandingWave{pi, 1, 0.004, 1}.Root();
  const auto scaled = StandingWave{pi / 3, 3, 0.004 * 9 / time, 5}.Root();
  EXPECT_NEAR(std::abs(scaled * time - root), 0, 1e-10);
}

TEST(StandingWave, InDeepWaterWithLittleViscosityIsLambs) {
  // s = -2 nu k^2 + i sqrt(gk) up to nu^(3/2).
  const double nu = 1e-6;
  const auto root = StandingWave{2, 50, nu, 9.81}.Root();
  EXPECT_NEAR(root.real() / (-2 * nu * 4), 1, 3e-3);
  EXPECT_NEAR(root.imag(), std::sqrt(2 * 9.81), 1e-5);
}

TEST(StandingWave, ShapeHasNoDivergenceAndNoCurlAndStaysInTheTank) {
  const StandingWave wave{pi, 1, 0.004, 1};
  constexpr double d = 1e-4;
  for (const Vec2 p : {Vec2{0.3, 0.2}, Vec2{1.1, 0.9}, Vec2{1.7, 0.5}}) {
    const Vec2 dx = 0.5 / d * (wave.Shape(p.x + d, p.y) - wave.Shape(p.x - d, p.y));
    const Vec2 dy = 0.5 / d * (wave.Shape(p.x, p.y + d) - wave.Shape(p.x, p.y - d));
    EXPECT_NEAR(dx.x + dy.y, 0, 1e-6);
    EXPECT_NEAR(dx.y - dy.x, 0, 1e-6);
  }
  EXPECT_NEAR(wave.Shape(2, 0.4).x, 0, 1e-12);
  EXPECT_EQ(wave.Shape(0.3, 0).y, 0);
  EXPECT_NEAR(std::abs(wave.Shape(0, 1).y), 1, 1e-12);
}

TEST(FitDecay, FindsWhatTheOscillationWasMadeWith) {
  PointSeries samples;
  Random random(5);
  for (int k = 0; k <= 700; ++k) {
    const double t = 0.04 * k;
    samples.push_back({t, 3 * std::exp(-0.07 * t) * std::cos(1.76 * t) + random.Uniform(-0.01, 0.01)});
  }
  const auto fit = FitDecay(samples);
  EXPECT_NEAR(fit.real(), -0.07, 1e-4);
  EXPECT_NEAR(fit.imag(), 1.76, 1e-3);
}

TEST(FitDecay, KnowsNothingOfWhatDoesNotSwing) {
  EXPECT_TRUE(std::isnan(FitDecay({{0, 1}, {1, 0.5}, {2, 0.1}}).real()));
  EXPECT_TRUE(std::isnan(FitDecay({}).imag()));
}

}  // namespace
}  // namespace sph
