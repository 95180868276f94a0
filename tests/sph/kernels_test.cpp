// The kernels' constants, gradients and Laplacians, found again by quadrature and differences.
#include "sph/kernels.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "sph/quadrature.hpp"

namespace sph {
namespace {

using std::numbers::pi;
constexpr double kH = 0.34;  // [m], a value at which no power of h is near 1
constexpr double kQuadrature =
    1e-11;  // the rule is exact for the pieces' polynomials; what is cut off near r = 0 is below 1e-12

template <typename Kernel>
double Integral(const Kernel& kernel, int dimension) {
  return IntegralOverAll([&](double r) { return kernel.Value(r); }, dimension, Kernel::kSupport * kH);
}

/// Distances over the support that are not on a knot.
std::vector<double> Distances(double support) {
  std::vector<double> distances;
  for (int k = 1; k < 100; ++k) distances.push_back(support * (k - 0.37) / 100);
  return distances;
}

/// W'(r) by a central difference; its error is delta^2 W'''/6 and round-off eps W/delta: together below 1e-9 of W(0)/h
/// here.
template <typename Kernel>
double Slope(const Kernel& kernel, double r) {
  const double delta = 1e-5 * kH;
  return (kernel.Value(r + delta) - kernel.Value(r - delta)) / (2 * delta);
}

TEST(CubicSpline, IntegratesToOneOverTheLine) { EXPECT_NEAR(Integral(CubicSpline<1>(kH), 1), 1, kQuadrature); }
TEST(CubicSpline, IntegratesToOneOverThePlane) { EXPECT_NEAR(Integral(CubicSpline<2>(kH), 2), 1, kQuadrature); }
TEST(CubicSpline, IntegratesToOneOverSpace) { EXPECT_NEAR(Integral(CubicSpline<3>(kH), 3), 1, kQuadrature); }
TEST(Poly6, IntegratesToOneOverThePlane) { EXPECT_NEAR(Integral(Poly6(kH), 2), 1, kQuadrature); }
TEST(Spiky, IntegratesToOneOverThePlane) { EXPECT_NEAR(Integral(Spiky(kH), 2), 1, kQuadrature); }
TEST(ViscosityKernel, IntegratesToOneOverThePlane) { EXPECT_NEAR(Integral(ViscosityKernel(kH), 2), 1, kQuadrature); }

TEST(CubicSpline, WithTheConstantThatThePaperPrintsIntegratesToThree) {
  const double printed = 15 / (14 * pi * kH * kH);
  const double right = CubicSpline<2>(kH).Value(0) / 4;  // W(0) = C (2^3 - 4)
  EXPECT_NEAR(printed / right * Integral(CubicSpline<2>(kH), 2), 3, 3 * kQuadrature);
}

TEST(CubicSpline, OnASquareGridOfPointsSumsToOne) {
  // The plane's integral without polar coordinates: sums over a grid of pitch p miss a smooth function by about p^5
  // here.
  const CubicSpline<2> kernel(kH);
  const double pitch = kH / 50;
  double sum = 0;
  for (int i = -101; i <= 101; ++i) {
    for (int j = -101; j <= 101; ++j) sum += pitch * pitch * kernel.Value(std::hypot(i * pitch, j * pitch));
  }
  EXPECT_NEAR(sum, 1, 1e-7);
}

template <typename Kernel>
class CubicSplineInEveryDimension : public ::testing::Test {};
using Splines = ::testing::Types<CubicSpline<1>, CubicSpline<2>, CubicSpline<3>>;
TYPED_TEST_SUITE(CubicSplineInEveryDimension, Splines);

TYPED_TEST(CubicSplineInEveryDimension, GradientIsTheValuesDerivativeOverR) {
  const TypeParam kernel(kH);
  const double scale = kernel.Value(0) / kH;
  for (const double r : Distances(2 * kH)) EXPECT_NEAR(kernel.Gradient(r) * r, Slope(kernel, r), 1e-9 * scale) << r;
}

TYPED_TEST(CubicSplineInEveryDimension, GradientIsNeverPositiveAndFiniteInTheMiddle) {
  const TypeParam kernel(kH);
  for (int k = 0; k <= 300; ++k) EXPECT_LE(kernel.Gradient(0.01 * k * kH), 0) << k;
  EXPECT_DOUBLE_EQ(kernel.Gradient(0), -12 * (kernel.Value(0) / 4) / (kH * kH));
  EXPECT_NEAR(kernel.Gradient(1e-9 * kH), kernel.Gradient(0),
              1e-8 * std::abs(kernel.Gradient(0)));  // g changes by 9 q of 12
}

TYPED_TEST(CubicSplineInEveryDimension, EndsAtTwiceH) {
  const TypeParam kernel(kH);
  const double next = std::nextafter(2 * kH, 10);
  for (const double r : {2 * kH, next, 3 * kH, 1e300}) {
    EXPECT_EQ(kernel.Value(r), 0) << r;
    EXPECT_EQ(kernel.Gradient(r), 0) << r;
  }
  EXPECT_GT(kernel.Value(1.999 * kH), 0);
}

TYPED_TEST(CubicSplineInEveryDimension, ValueAndGradientAreContinuousAtTheKnots) {
  const TypeParam kernel(kH);
  const double tiny = 1e-9 * kH;  // both change by less than 12 tiny/h of their greatest value
  for (const double knot : {kH, 2 * kH}) {
    EXPECT_NEAR(kernel.Value(knot - tiny), kernel.Value(knot + tiny), 24e-9 * kernel.Value(0));
    EXPECT_NEAR(kernel.Gradient(knot - tiny), kernel.Gradient(knot + tiny), 24e-9 * std::abs(kernel.Gradient(0)));
  }
}

TEST(QuinticSpline, IntegratesToOneOverThePlane) {
  const QuinticSpline kernel(kH);  // polynomials of degree 6 between knots: the rule is exact on each
  EXPECT_NEAR(sph::Integral([&](double r) { return 2 * pi * r * kernel.Value(r); }, 0, 3 * kH, 3), 1, 1e-13);
}

TEST(QuinticSpline, GradientIsTheValuesDerivativeOverR) {
  const QuinticSpline kernel(kH);
  const double scale = kernel.Value(0) / kH;
  for (const double r : Distances(3 * kH)) EXPECT_NEAR(kernel.Gradient(r) * r, Slope(kernel, r), 1e-9 * scale) << r;
  const double delta = 1e-3 * kH;
  EXPECT_NEAR(kernel.Gradient(0), 2 * (kernel.Value(delta) - kernel.Value(0)) / (delta * delta), 1e-5 * scale / kH);
}

TEST(QuinticSpline, IsTheCubicSplinesNextOfKin) {
  // Both are B-splines made isotropic: fourth differences of x^3 and sixth ones of x^5, here for the quintic.
  const QuinticSpline kernel(kH);
  const double binomials[] = {1, 6, 15, 20, 15, 6, 1};
  for (const double q : {0.1, 0.8, 1.3, 2.6}) {
    const auto spline = [&](double x) {
      double sum = 0;
      for (int k = 0; k <= 6; ++k) {
        sum += (k % 2 == 0 ? 1 : -1) * binomials[k] * std::pow(std::max(0.0, x + 3 - k), 5);
      }
      return sum;
    };
    EXPECT_NEAR(kernel.Value(q * kH) / kernel.Value(0), spline(q) / spline(0), 1e-13) << q;
  }
}

TEST(QuinticSpline, FallsAllTheWayAndEndsAtThreeH) {
  const QuinticSpline kernel(kH);
  for (int k = 0; k < 300; ++k) {
    EXPECT_GT(kernel.Value(0.01 * k * kH), kernel.Value(0.01 * (k + 1) * kH)) << k;
    EXPECT_LT(kernel.Gradient(0.01 * k * kH), 0) << k;
  }
  for (const double r : {3 * kH, std::nextafter(3 * kH, 10), 1e100}) {
    EXPECT_EQ(kernel.Value(r), 0) << r;
    EXPECT_EQ(kernel.Gradient(r), 0) << r;
  }
}

TEST(SepticSpline, IntegratesToOneOverThePlane) {
  const SepticSpline kernel(kH);  // polynomials of degree 8 between knots: the rule is exact on each
  EXPECT_NEAR(sph::Integral([&](double r) { return 2 * pi * r * kernel.Value(r); }, 0, 4 * kH, 4), 1, 1e-13);
}

TEST(SepticSpline, GradientIsTheValuesDerivativeOverR) {
  const SepticSpline kernel(kH);
  const double scale = kernel.Value(0) / kH;
  for (const double r : Distances(4 * kH)) EXPECT_NEAR(kernel.Gradient(r) * r, Slope(kernel, r), 1e-9 * scale) << r;
}

TEST(SepticSpline, IsTheBSplineOfEighthDifferences) {
  const SepticSpline kernel(kH);
  const double binomials[] = {1, 8, 28, 56, 70, 56, 28, 8, 1};
  for (const double q : {0.1, 0.8, 1.3, 2.6, 3.5}) {
    const auto spline = [&](double x) {
      double sum = 0;
      for (int k = 0; k <= 8; ++k) {
        sum += (k % 2 == 0 ? 1 : -1) * binomials[k] * std::pow(std::max(0.0, x + 4 - k), 7);
      }
      return sum;
    };
    EXPECT_NEAR(kernel.Value(q * kH) / kernel.Value(0), spline(q) / spline(0), 1e-11) << q;
  }
}

TEST(SepticSpline, FallsAllTheWayAndEndsAtFourH) {
  const SepticSpline kernel(kH);
  for (int k = 0; k < 400; ++k) {
    EXPECT_GT(kernel.Value(0.01 * k * kH), kernel.Value(0.01 * (k + 1) * kH)) << k;
    EXPECT_LT(kernel.Gradient((0.01 * k + 0.001) * kH), 0) << k;
  }
  for (const double r : {4 * kH, std::nextafter(4 * kH, 10), 1e100}) {
    EXPECT_EQ(kernel.Value(r), 0) << r;
    EXPECT_EQ(kernel.Gradient(r), 0) << r;
  }
}

/// W'/r (kFlat - kFall s^2), s = r/R.
double SharpSlope(const SepticSpline& kernel, double r, double support) {
  return kernel.Gradient(r) * (SepticSpline::kFlat - SepticSpline::kFall * std::pow(r / support, 2));
}

TEST(SepticSpline, SharpSlopeHasTheSecondMomentOfTheSlopeAndNoFourth) {
  const SepticSpline kernel(kH);
  const auto moment = [&](int power, const auto& slope) {
    // On each piece a polynomial of degree 12 at most; two panels each bring the rule's error below round-off.
    return sph::Integral([&](double r) { return 2 * pi * r * std::pow(r / kH, power) * slope(r); }, 0, 4 * kH, 16);
  };
  const auto plain = [&](double r) { return kernel.Gradient(r); };
  const auto sharp = [&](double r) { return SharpSlope(kernel, r, 4 * kH); };
  const double second = moment(2, plain);
  EXPECT_NEAR(second, -2 / (kH * kH), 1e-11);  // by parts: -2 times the integral of W
  EXPECT_NEAR(moment(2, sharp) / second, 1, 1e-12);
  EXPECT_NEAR(moment(4, sharp) / moment(4, plain), 0, 1e-12);
}

TEST(SepticSpline, OnLatticesOfItsOwnSpacingSumsToFourDigits) {
  const SepticSpline kernel(1);
  for (const bool hexagonal : {false, true}) {
    const double pitch = hexagonal ? std::sqrt(2 / std::numbers::sqrt3) : 1, row_pitch = 1 / pitch;
    double sum = kernel.Value(0), second = 0;
    for (int row = -6; row <= 6; ++row) {
      for (int column = -9; column <= 9; ++column) {
        const double x = (column + (hexagonal ? 0.5 * row : 0)) * pitch, y = row * row_pitch;
        if (row == 0 && column == 0) continue;
        sum += kernel.Value(std::hypot(x, y));
        second -= 0.5 * (x * x + y * y) * SharpSlope(kernel, std::hypot(x, y), 4);
      }
    }
    EXPECT_NEAR(sum, 1, 5e-4) << hexagonal;
    EXPECT_NEAR(second, 1, 5e-4) << hexagonal;
  }
}

template <typename Kernel>
class Wendland : public ::testing::Test {};
using Wendlands = ::testing::Types<WendlandC2, WendlandC4>;
TYPED_TEST_SUITE(Wendland, Wendlands);

TYPED_TEST(Wendland, IntegratesToOneOverThePlane) { EXPECT_NEAR(Integral(TypeParam(kH), 2), 1, kQuadrature); }

TYPED_TEST(Wendland, GradientIsTheValuesDerivativeOverR) {
  const TypeParam kernel(kH);
  const double scale = kernel.Value(0) / kH;
  for (const double r : Distances(2 * kH)) EXPECT_NEAR(kernel.Gradient(r) * r, Slope(kernel, r), 1e-9 * scale) << r;
  // W has no linear term, so that W'/r has a limit at 0: W''(0), here by a second difference.
  const double delta = 1e-3 * kH;
  EXPECT_NEAR(kernel.Gradient(0), 2 * (kernel.Value(delta) - kernel.Value(0)) / (delta * delta), 5e-3 * scale / kH);
}

TYPED_TEST(Wendland, FallsAllTheWayAndEndsAtTwiceH) {
  const TypeParam kernel(kH);
  for (int k = 0; k < 200; ++k) {
    EXPECT_GT(kernel.Value(0.01 * k * kH), kernel.Value(0.01 * (k + 1) * kH)) << k;
    EXPECT_LT(kernel.Gradient(0.01 * k * kH), 0) << k;
  }
  for (const double r : {2 * kH, std::nextafter(2 * kH, 10), 3 * kH, 1e100}) {
    EXPECT_EQ(kernel.Value(r), 0) << r;
    EXPECT_EQ(kernel.Gradient(r), 0) << r;
  }
}

TYPED_TEST(Wendland, HasATransformThatIsNowhereNegativeSoThatParticlesDoNotPair) {
  // What(K) = 2 pi int W J0(K r) r dr [Dehnen & Aly 2012]; that of the cubic spline is negative from K h = 5.9 or so
  // on.
  const auto transform = [](const auto& kernel, double k) {
    return IntegralOverAll([&](double r) { return kernel.Value(r) * std::cyl_bessel_j(0.0, k * r / kH); }, 2, 2 * kH);
  };
  double least = 1, least_of_spline = 1;
  for (double k = 0.5; k < 12; k += 0.25) {
    least = std::min(least, transform(TypeParam(kH), k));
    least_of_spline = std::min(least_of_spline, transform(CubicSpline<2>(kH), k));
  }
  EXPECT_GT(least, 0);
  EXPECT_LT(least_of_spline, 0);
}

TEST(Poly6, EndsAtHAndFallsAllTheWay) {
  const Poly6 kernel(kH);
  EXPECT_EQ(kernel.Value(kH), 0);
  EXPECT_EQ(kernel.Value(1e300), 0);  // r^2 overflows
  for (int k = 0; k < 100; ++k) EXPECT_GT(kernel.Value(0.01 * k * kH), kernel.Value(0.01 * (k + 1) * kH)) << k;
}

TEST(Spiky, SlopeIsTheValuesDerivative) {
  const Spiky kernel(kH);
  const double scale = kernel.Value(0) / kH;
  for (const double r : Distances(kH)) EXPECT_NEAR(kernel.Slope(r), Slope(kernel, r), 1e-9 * scale) << r;
}

TEST(Spiky, RepelsMostWhereParticlesMeetAndEndsAtH) {
  const Spiky kernel(kH);
  for (int k = 0; k < 100; ++k) EXPECT_LT(kernel.Slope(0.01 * k * kH), kernel.Slope(0.01 * (k + 1) * kH)) << k;
  EXPECT_EQ(kernel.Slope(kH), 0);
  EXPECT_EQ(kernel.Value(2 * kH), 0);
}

/// For a W that is 0 at `radius`, integration by parts turns the integral of W over the plane into -pi times that of
/// r^2 W'.
template <typename F>
double IntegralOfTheKernelWithSlope(F slope, double radius) {
  return IntegralOverAll([&](double r) { return -0.5 * r * slope(r); }, 2, radius);
}

TEST(Spiky, TheTutorialsGradientBelongsToNoNormalisedKernel) {
  for (const double h : {0.16, 1.0, 16.0}) {
    const Spiky kernel(h);
    EXPECT_NEAR(IntegralOfTheKernelWithSlope([&](double r) { return kernel.Slope(r); }, h), 1, kQuadrature);
    const auto published = [h](double r) { return -10 / (pi * std::pow(h, 5)) * std::pow(h - r, 3); };
    // h/6: not 1, and not even a number without a unit; 2.7 in the tutorial's pixels, 0.027 in the same scene in
    // metres.
    EXPECT_NEAR(IntegralOfTheKernelWithSlope(published, h), h / 6, kQuadrature * h);
  }
}

TEST(ViscosityKernel, LaplacianInThePlaneIsThatOfItsValue) {
  // By the five-point formula around (r cos a, r sin a); its error is delta^2/12 times fourth derivatives, which the
  // logarithm makes as large as 6 c h^3/(6 r^4): with delta = r/1000 below 1e-6 of the Laplacian at r = h/20, and less
  // further out.
  const ViscosityKernel kernel(kH);
  for (const double r : Distances(kH)) {
    if (r < kH / 20 || r > 0.99 * kH) continue;
    const double delta = 1e-3 * r;
    const double x = r * std::cos(0.7), y = r * std::sin(0.7);
    const auto at = [&](double dx, double dy) { return kernel.Value(std::hypot(x + dx, y + dy)); };
    const double laplacian =
        (at(delta, 0) + at(-delta, 0) + at(0, delta) + at(0, -delta) - 4 * at(0, 0)) / (delta * delta);
    EXPECT_NEAR(laplacian, kernel.Laplacian(r), 2e-3 * kernel.Laplacian(0)) << r / kH;
  }
}

TEST(ViscosityKernel, MeetsZeroWithValueAndSlopeAtH) {
  const ViscosityKernel kernel(kH);
  const double scale = kernel.Value(kH / 2);
  EXPECT_NEAR(kernel.Value(kH * (1 - 1e-6)), 0,
              1e-11 * scale);  // a double root: (1e-6)^2 times a constant, and round-off
  EXPECT_NEAR(Slope(kernel, kH * (1 - 1e-4)), 0, 1e-3 * scale / kH);
  EXPECT_EQ(kernel.Laplacian(kH), 0);
  EXPECT_EQ(kernel.Value(2 * kH), 0);
}

TEST(ViscosityKernel, LaplacianIsNeverNegativeSoThatItNeverPushesVelocitiesApart) {
  const ViscosityKernel kernel(kH);
  for (int k = 0; k <= 200; ++k) EXPECT_GE(kernel.Laplacian(0.01 * k * kH), 0) << k;
}

TEST(Kernels, RefuseASmoothingLengthThatIsNotPositive) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(CubicSpline<2>(0), "h = 0");
  EXPECT_DEATH(Poly6(-1), "h = -1");
  EXPECT_DEATH(WendlandC2(0), "h = 0");
  EXPECT_DEATH(WendlandC4(-2), "h = -2");
  EXPECT_DEATH(QuinticSpline(0), "h = 0");
  EXPECT_DEATH(SepticSpline(0), "h = 0");
  EXPECT_DEATH(Spiky{std::nan("")}, "h = nan");
  EXPECT_DEATH(ViscosityKernel(0), "h = 0");
}

}  // namespace
}  // namespace sph
