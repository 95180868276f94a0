#include "lab/plot_axes.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> LabelsOf(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticks) {
    if (!tick.label.empty()) labels.push_back(tick.label);
  }
  return labels;
}

using Labels = std::vector<std::string>;

Extent ExtentOf(std::vector<double> values, Scale scale = Scale::kLinear) {
  Extent extent(scale);
  extent.Add(values);
  return extent;
}

RC_GTEST_PROP(LinearTicks, AreMultiplesOfOneTwoOrFiveWithinTheAxis, ()) {
  const double low = *rc::gen::inRange(-1000, 1000) * 0.37;
  const double high = low + *rc::gen::inRange(1, 1000) * std::pow(10.0, *rc::gen::inRange(-6, 6));
  const int at_most = *rc::gen::inRange(2, 15);
  const auto ticks = LinearTicks(low, high, at_most);

  // The next smaller step has more than at_most multiples here, and is at least 1/2.5 of this one.
  RC_ASSERT(ticks.size() >= static_cast<std::size_t>(std::floor(at_most / 2.5)));
  RC_ASSERT(ticks.size() <= static_cast<std::size_t>(at_most));
  for (const Tick& tick : ticks) {
    RC_ASSERT(tick.value >= low && tick.value <= high);
    RC_ASSERT(!tick.label.empty());
  }
  if (ticks.size() < 2) return;
  // Rounding of the difference of two ticks, against a step that may be 1e-9 of them.
  const double step = (ticks.back().value - ticks.front().value) / static_cast<double>(ticks.size() - 1);
  const double decade = std::pow(10.0, std::floor(std::log10(step * 1.001)));
  const std::array<double, 3> round = {1, 2, 5};
  RC_ASSERT(std::any_of(round.begin(), round.end(), [&](double m) { return std::abs(step / decade - m) < 1e-3 * m; }));
}

TEST(LinearTicks, HaveTheDecimalsOfTheirStep) {
  EXPECT_EQ(LabelsOf(LinearTicks(0, 1, 6)), (Labels{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(LabelsOf(LinearTicks(-1.2, 1.3, 6)), (Labels{"−1.0", "−0.5", "0", "0.5", "1.0"}));
  EXPECT_EQ(LabelsOf(LinearTicks(0, 20, 5)), (Labels{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(LabelsOf(LinearTicks(1000, 1000.5, 3)), (Labels{"1000.0", "1000.2", "1000.4"}));
}

TEST(LinearTicks, OfVeryLargeAndVerySmallNumbersNameTheirPowerOfTen) {
  EXPECT_EQ(LabelsOf(LinearTicks(0, 2e9, 3)), (Labels{"0", "1×10⁹", "2×10⁹"}));
  EXPECT_EQ(LabelsOf(LinearTicks(0, 5e-5, 3)), (Labels{"0", "2×10⁻⁵", "4×10⁻⁵"}));
  EXPECT_EQ(LabelsOf(LinearTicks(-3e-12, 0, 4)), (Labels{"−3×10⁻¹²", "−2×10⁻¹²", "−1×10⁻¹²", "0"}));
}

TEST(LogTicks, MarkDecadesAndTheDigitsBetweenThem) {
  const auto ticks = LogTicks(1e-4, 1, 9);
  EXPECT_EQ(LabelsOf(ticks), (Labels{"10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"}));
  EXPECT_EQ(ticks.size(), 5U + 4 * 8);
  for (const Tick& tick : ticks) {
    const double digit = tick.value / std::pow(10.0, std::floor(std::log10(tick.value * 1.001)));
    EXPECT_NEAR(digit, std::round(digit), 1e-9) << tick.value;
    EXPECT_EQ(tick.label.empty(), std::round(digit) != 1) << tick.value;
  }
  EXPECT_EQ(LabelsOf(LogTicks(0.01, 100, 9)), (Labels{"0.01", "0.1", "1", "10", "100"}));
}

TEST(LogTicks, LeaveOutDecadesWhereThereIsNoRoom) {
  const auto ticks = LogTicks(1e-9, 1e3, 5);
  EXPECT_EQ(LabelsOf(ticks), (Labels{"10⁻⁹", "10⁻⁶", "10⁻³", "10⁰", "10³"}));
  EXPECT_EQ(ticks.size(), 13U) << "the decades left out are minor ticks";
}

TEST(LogTicks, OfAShortAxisLabelOtherDigitsToo) {
  EXPECT_EQ(LabelsOf(LogTicks(0.05, 2, 9)), (Labels{"0.05", "0.1", "0.2", "0.5", "1", "2"}));
  EXPECT_EQ(LabelsOf(LogTicks(0.05, 2, 4)), (Labels{"0.1", "0.3", "1"}));
  EXPECT_EQ(LabelsOf(LogTicks(0.05, 2, 2)), (Labels{"0.1", "1"}));
  EXPECT_EQ(LabelsOf(LogTicks(3.1, 3.4, 4)), (Labels{"3.1", "3.2", "3.3", "3.4"}));
}

RC_GTEST_PROP(LogTicks, AreWithinTheAxisAndAtMostAsManyLabelsAsAsked, ()) {
  const double low = std::pow(10.0, 0.01 * *rc::gen::inRange(-3000, 3000));
  const double high = low * std::pow(10.0, 0.01 * *rc::gen::inRange(1, 2000));
  const int at_most = *rc::gen::inRange(2, 12);
  const auto ticks = LogTicks(low, high, at_most);
  const auto labels = LabelsOf(ticks).size();
  RC_ASSERT(labels >= 1U || at_most < 3);  // LinearTicks promises at_most / 2.5
  RC_ASSERT(labels <= static_cast<std::size_t>(at_most));
  for (const Tick& tick : ticks) RC_ASSERT(tick.value >= low && tick.value <= high);
}

TEST(PowerOfTen, IsWrittenWithRaisedDigits) {
  EXPECT_EQ(PowerOfTen(0), "10⁰");
  EXPECT_EQ(PowerOfTen(-12), "10⁻¹²");
  EXPECT_EQ(PowerOfTen(305), "10³⁰⁵");
}

TEST(AxisMap, PutsValuesWhereTheirScaleSays) {
  const AxisMap linear = {Scale::kLinear, -1, 3, 100, 500};
  EXPECT_DOUBLE_EQ(linear.ToPixel(-1), 100);
  EXPECT_DOUBLE_EQ(linear.ToPixel(0), 200);
  EXPECT_DOUBLE_EQ(linear.ToPixel(3), 500);
  const AxisMap upwards = {Scale::kLog, 1e-2, 1e2, 400, 0};  // y axes have their first pixel at the bottom
  EXPECT_DOUBLE_EQ(upwards.ToPixel(1e-2), 400);
  EXPECT_DOUBLE_EQ(upwards.ToPixel(1), 200);
  EXPECT_DOUBLE_EQ(upwards.ToPixel(10), 100);
  EXPECT_NEAR(upwards.At(0.75), 10, 1e-12);
  EXPECT_NEAR(linear.At(0.25), 0, 1e-12);
}

TEST(FitAxis, LeavesAMarginButNotAcrossZero) {
  const AxisMap free = FitAxis({}, ExtentOf({2, 3}));
  EXPECT_NEAR(free.low, 1.96, 1e-12);
  EXPECT_NEAR(free.high, 3.04, 1e-12);
  EXPECT_EQ(FitAxis({}, ExtentOf({0, 1})).low, 0);
  EXPECT_EQ(FitAxis({}, ExtentOf({-1, 0})).high, 0);
  EXPECT_LT(FitAxis({}, ExtentOf({-1, 1})).low, -1);
  EXPECT_EQ(FitAxis({}, ExtentOf({2, 3}), false).low, 2);
}

TEST(FitAxis, KeepsTheEndsThatItIsGiven) {
  const Axis from_one = {.low = 1};
  EXPECT_EQ(FitAxis(from_one, ExtentOf({2, 3})).low, 1);
  EXPECT_GT(FitAxis(from_one, ExtentOf({-3, -2})).high, 1) << "all data are below";
  const Axis log = {.scale = Scale::kLog, .low = 0.01, .high = 10};
  EXPECT_EQ(FitAxis(log, ExtentOf({2, 300}, Scale::kLog)).low, 0.01);
  EXPECT_EQ(FitAxis(log, ExtentOf({2, 300}, Scale::kLog)).high, 10);
}

TEST(FitAxis, IsNeverEmpty) {
  for (const Scale scale : {Scale::kLinear, Scale::kLog}) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, {5}, {0}, {-7, -7}, {kNan, kInfinity}, {1e-200}, {1e299, 1}, {1, 1 + 1e-15}}) {
      const AxisMap axis = FitAxis({.scale = scale}, ExtentOf(values, scale));
      EXPECT_LT(axis.low, axis.high);
      EXPECT_TRUE(std::isfinite(axis.high - axis.low));
      const auto ticks = scale == Scale::kLog ? LogTicks(axis.low, axis.high, 9) : LinearTicks(axis.low, axis.high, 9);
      EXPECT_GE(LabelsOf(ticks).size(), 2U) << axis.low << " to " << axis.high;
    }
  }
}

TEST(Extent, TakesOnlyWhatTheScaleCanShow) {
  const Extent log = ExtentOf({-1, 0, kNan, 3, kInfinity, 2}, Scale::kLog);
  EXPECT_EQ(log.Low(), 2);
  EXPECT_EQ(log.High(), 3);
  const Extent linear = ExtentOf({-1, 0, kNan, 3, -kInfinity});
  EXPECT_EQ(linear.Low(), -1);
  EXPECT_EQ(linear.High(), 3);
  EXPECT_TRUE(ExtentOf({-1, 0}, Scale::kLog).Empty());
}

TEST(FitAxisDeathTest, RefusesImpossibleEnds) {
  EXPECT_DEATH(FitAxis({.label = "r [m]", .scale = Scale::kLog, .low = 0}, ExtentOf({1, 2})), "r \\[m\\]");
  EXPECT_DEATH(FitAxis({.low = 2, .high = 1}, ExtentOf({1, 2})), "from 2 to 1");
}

}  // namespace
}  // namespace sph
