// Series: values between points, and delays.
#include "lab/series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sph {
namespace {

const PointSeries kRamp = {{0, 1}, {1, 3}, {3, 3}, {4, 7}};

TEST(Series, ValueIsLinearBetweenPointsAndConstantBeyondThem) {
  EXPECT_EQ(ValueAt(kRamp, 0.5), 2);
  EXPECT_EQ(ValueAt(kRamp, 1), 3);
  EXPECT_EQ(ValueAt(kRamp, 3.25), 4);
  EXPECT_EQ(ValueAt(kRamp, -1), 1);
  EXPECT_EQ(ValueAt(kRamp, 9), 7);
}

TEST(Series, FirstAboveIsWhereALevelIsPassedUpwards) {
  EXPECT_EQ(FirstAbove(kRamp, 2), 0.5);
  EXPECT_EQ(FirstAbove(kRamp, 5), 3.5);
  EXPECT_TRUE(std::isinf(FirstAbove(kRamp, 8)));
  EXPECT_TRUE(std::isinf(FirstAbove(kRamp, 0.5))) << "above it from the beginning";
  EXPECT_TRUE(std::isinf(FirstAbove({}, 0.5)));
}

TEST(Series, DifferenceIsTheRootMeanSquareAtTheMeasuredPoints) {
  EXPECT_EQ(Difference(kRamp, {{0.5, 2}, {3.25, 4}}), 0);
  EXPECT_DOUBLE_EQ(Difference(kRamp, {{0.5, 5}, {3.25, 8}}), std::sqrt(0.5 * (9 + 16)));
}

TEST(Series, BestDelayIsTheOneThatTheSeriesWasShiftedBy) {
  PointSeries computed, measured;
  for (int k = 0; k < 100; ++k) computed.push_back({0.05 * k, std::exp(0.3 * 0.05 * k)});
  for (int k = 10; k < 30; ++k) measured.push_back({0.1 * k, std::exp(0.3 * (0.1 * k - 0.27))});
  const double delay = BestDelay(computed, measured, 0.6);
  EXPECT_NEAR(delay, 0.27, 0.0007);  // in steps of 0.0006
  EXPECT_LT(Difference(computed, measured, delay), 1e-3);
  EXPECT_GT(Difference(computed, measured), 0.1);
}

}  // namespace
}  // namespace sph
