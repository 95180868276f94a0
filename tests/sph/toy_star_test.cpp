// The exact star: its mass, its balance of forces, and the measure of distance from it.
#include "sph/toy_star.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sph/quadrature.hpp"

namespace sph {
namespace {

const ToyStar kStar{2.0, 0.75, 0.1};  // Table I

double IntegralOfDensity(const ToyStar& star) {
  return IntegralOverAll([&](double r) { return star.Density(r); }, 2, star.radius);
}

TEST(ToyStar, DensityIntegratesToTheMass) {
  EXPECT_NEAR(IntegralOfDensity(kStar), 2.0, 1e-11);
  EXPECT_NEAR(IntegralOfDensity({0.3, 4.0, 7.0}), 0.3, 1e-11);
}

TEST(ToyStar, CentralForceIsTheOneForWhichAStarOfThatMassEndsAtR) {
  // Eq. 22 with lambda = 1 holds a mass per lambda; M over it is lambda.
  const auto with_unit_lambda = [](double r) { return 1 / (4 * kStar.k) * (kStar.radius * kStar.radius - r * r); };
  const double lambda = kStar.mass / IntegralOverAll(with_unit_lambda, 2, kStar.radius);
  EXPECT_NEAR(kStar.CentralForce(), lambda, 1e-11 * lambda);
}

TEST(ToyStar, PressureGradientBalancesTheCentralForce) {
  // Eq. 21 with v = 0: -2k rho' = lambda r. A central difference is exact for a parabola.
  for (const double r : {0.1, 0.4, 0.7}) {
    const double slope = (kStar.Density(r + 0.01) - kStar.Density(r - 0.01)) / 0.02;
    EXPECT_NEAR(-2 * kStar.k * slope, kStar.CentralForce() * r, 1e-13);
  }
}

TEST(ToyStar, HasNoDensityFromItsRadiusOn) {
  EXPECT_EQ(kStar.Density(0.75), 0);
  EXPECT_EQ(kStar.Density(10), 0);
  EXPECT_GT(kStar.Density(0.7499), 0);
}

TEST(CompareDensity, IsZeroForTheExactDensity) {
  const std::vector<double> x = {0, 0.3, -0.5, 0.9};
  const std::vector<double> y = {0, 0.4, 0.1, 0.9};
  std::vector<double> density;
  for (std::size_t i = 0; i < x.size(); ++i) density.push_back(kStar.Density(std::hypot(x[i], y[i])));
  const DensityErrors errors = CompareDensity(kStar, x, y, density);
  EXPECT_EQ(errors.mse, 0);
  EXPECT_EQ(errors.rms_relative, 0);
}

TEST(CompareDensity, IsTheMeanSquareAndItsRootOverTheCentre) {
  const std::vector<double> x = {0, 10, 10, 10}, y = {0, 0, 0, 0};
  const std::vector<double> density = {kStar.Density(0) + 0.2, 0.4, -0.4, 0};
  const DensityErrors errors = CompareDensity(kStar, x, y, density);
  EXPECT_DOUBLE_EQ(errors.mse, (0.04 + 0.16 + 0.16) / 4);
  EXPECT_DOUBLE_EQ(errors.rms_relative, std::sqrt(0.09) / (2 * 2.0 / (M_PI * 0.5625)));  // rho_c = 2M/(pi R^2)
}

TEST(CompareDensity, OfNoParticlesIsZero) { EXPECT_EQ(CompareDensity(kStar, {}, {}, {}).mse, 0); }

}  // namespace
}  // namespace sph
