// The random numbers are those of the standard's Mersenne twister, the same on every machine.
#include "base/random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace sph {
namespace {

TEST(Random, RepeatsTheNumberThatTheStandardPrescribes) {
  // [rand.predef]: the 10000th number of mt19937_64, seeded with 5489, is 9981545732273789042. We keep its upper 53
  // bits.
  Random random(5489);
  for (int k = 1; k < 10000; ++k) random.Uniform();
  EXPECT_EQ(random.Uniform(), std::ldexp(static_cast<double>(9981545732273789042ULL >> 11), -53));
}

RC_GTEST_PROP(Random, StaysInItsHalfOpenRangeAndRepeatsItself, (std::uint64_t seed)) {
  Random random(seed);
  Random again(seed);
  for (int k = 0; k < 100; ++k) {
    const double u = random.Uniform();
    RC_ASSERT(u >= 0 && u < 1);
    RC_ASSERT(u * 0x1.0p53 == std::floor(u * 0x1.0p53));
    RC_ASSERT(again.Uniform() == u);
    const double v = random.Uniform(-0.95, -0.35);
    RC_ASSERT(v >= -0.95 && v < -0.35);
    RC_ASSERT(again.Uniform(-0.95, -0.35) == v);
  }
}

TEST(Random, OtherSeedsGiveOtherNumbers) {
  Random one(1);
  Random two(2);
  EXPECT_NE(one.Uniform(), two.Uniform());
}

TEST(Random, HasMeanAndVarianceOfTheUniformDistribution) {
  constexpr int kNumbers = 100000;
  Random random(1);
  double sum = 0, squares = 0;
  for (int k = 0; k < kNumbers; ++k) {
    const double u = random.Uniform();
    sum += u;
    squares += u * u;
  }
  // Four standard deviations of the mean of u (sqrt(1/12)) and of u^2 (sqrt(4/45)): the seed is fixed, so no luck is
  // needed.
  EXPECT_NEAR(sum / kNumbers, 1.0 / 2, 4 * std::sqrt(1.0 / 12 / kNumbers));
  EXPECT_NEAR(squares / kNumbers, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / kNumbers));
}

}  // namespace
}  // namespace sph
