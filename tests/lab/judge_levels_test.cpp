// The rules by which metrics hold: what falls as promised, what only seems to, and what grows.
#include "lab/judge_levels.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace sph {
namespace {

Verdict Bar(double bar, MetricKind kind = MetricKind::kError) {
  Verdict verdict{"m", 0, bar, "exact"};
  verdict.kind = kind;
  verdict.promise = {2, "of second order"};
  return verdict;
}

/// At 100, 400, 1600 particles; the case's own number is the second, or the first where there is only one.
Judged Judge(const Verdict& verdict, const std::vector<double>& values, const std::vector<double>& seeds = {}) {
  std::vector<Level> levels;
  for (std::size_t particles = 100; const double value : values) {
    levels.push_back({particles, value});
    particles *= 4;
  }
  return JudgeLevels(verdict, levels, std::min<std::size_t>(1, levels.size() - 1), seeds);
}

TEST(JudgeLevels, AnErrorOfSecondOrderHoldsAndHasThatOrder) {
  for (const double sign : {1.0, -1.0}) {
    const Judged judged = Judge(Bar(0.25), {sign, 0.25 * sign, 0.0625 * sign});
    EXPECT_TRUE(judged.holds);
    EXPECT_FALSE(judged.changes_sign);
    EXPECT_NEAR(*judged.order, 2, 1e-12);
  }
}

TEST(JudgeLevels, AnErrorAboveItsBarIsOpenHoweverItFalls) {
  EXPECT_FALSE(Judge(Bar(0.24), {1, 0.25, 0.0625}).holds);
  EXPECT_FALSE(Judge(Bar(0.24), {-1, -0.25, -0.0625}).holds);
}

TEST(JudgeLevels, AnErrorThatStopsFallingIsOpen) {
  EXPECT_FALSE(Judge(Bar(1), {1, 0.01, 0.02}).holds) << "of order 2.8 over all, and yet it rises";
  EXPECT_FALSE(Judge(Bar(1), {0.1, 0.1}).holds);
}

TEST(JudgeLevels, LessThanHalfTheOrderIsOpen) {
  EXPECT_TRUE(Judge(Bar(1), {1, 0.5, 0.25}).holds);
  EXPECT_FALSE(Judge(Bar(1), {1, 0.51, 0.26}).holds);
  Verdict strict = Bar(1);
  strict.promise.least = 1.7;
  EXPECT_FALSE(Judge(strict, {1, 0.5, 0.25}).holds) << "where more than half is demanded";
}

TEST(JudgeLevels, ASignedErrorThatCrossesZeroIsNotOfSecondOrder) {
  // The period of a breathing star with 750, 3000 and 12 000 particles, as it was when its figure was a crossing.
  const Judged crossing = Judge(Bar(2e-4), {4e-3, 2.4e-5, -9.4e-4});
  EXPECT_TRUE(crossing.changes_sign);
  EXPECT_FALSE(crossing.holds) << "the bar is held against 9.4e-4";
  EXPECT_NEAR(*crossing.order, std::log2(4e-3 / 9.4e-4), 1e-12) << "and the order of 4e-3 to 9.4e-4 is judged";
  EXPECT_FALSE(Judge(Bar(1), {4e-3, 2.4e-5, -9}).holds) << "beyond the zero it grows";
  EXPECT_FALSE(Judge(Bar(1), {-1e-3, 1e-3, -1e-3}).holds) << "swings, and does not fall";
}

TEST(JudgeLevels, TwoLevelsOfEitherSignHaveNoOrderAndMustBothBeWithinTheBar) {
  EXPECT_TRUE(Judge(Bar(0.5), {0.4, -0.1}).holds);
  EXPECT_FALSE(Judge(Bar(0.3), {0.4, -0.1}).holds);
  EXPECT_FALSE(Judge(Bar(0.5), {0.4, -0.1}).order);
}

RC_GTEST_PROP(JudgeLevels, NoOrderIsTakenThroughAZero, ()) {
  // e = a dx - b dx^2 with its zero between two levels: of first order, whatever two of its values pretend.
  const double zero = *rc::gen::map(rc::gen::inRange(26, 99), [](int percent) { return 0.01 * percent; });
  const auto error = [&](double dx) { return dx * (dx - zero); };
  const Judged judged = Judge(Bar(1), {error(1), error(0.5), error(0.25)});
  RC_ASSERT(judged.changes_sign);
  const double before = std::max(std::abs(error(1)), std::abs(error(0.5)));
  const double last = std::max(std::abs(error(0.5)), std::abs(error(0.25)));
  RC_ASSERT(std::abs(*judged.order - std::log2(before / last)) < 1e-9);
  RC_ASSERT(Judge(Bar(0.99 * last), {error(1), error(0.5), error(0.25)}).holds == false);
}

RC_GTEST_PROP(JudgeLevels, FindsAnyOrderAndHoldsFromHalfOfIt, ()) {
  const double order = *rc::gen::map(rc::gen::inRange(1, 400), [](int percent) { return 0.01 * percent; });
  const Judged judged = Judge(Bar(1), {1, std::exp2(-order), std::exp2(-2 * order)});
  RC_ASSERT(std::abs(*judged.order - order) < 1e-9);
  RC_ASSERT(judged.holds == (order > 0.995));
}

TEST(JudgeLevels, BelowItsFloorAnErrorNeedNotFall) {
  Verdict verdict = Bar(0.1);
  EXPECT_FALSE(Judge(verdict, {0.005, 0.005, 0.006}).holds);
  verdict.floor = {0.01, "round-off"};
  EXPECT_TRUE(Judge(verdict, {0.005, 0.005, 0.006}).holds);
  EXPECT_FALSE(Judge(verdict, {0.005, 0.2, 0.006}).holds) << "the bar counts as before";
  EXPECT_FALSE(Judge(verdict, {0.005, 0.005, 0.011}).holds) << "the finest is what is held against it";
}

TEST(JudgeLevelsDeathTest, AFloorIsATenthOfTheBarAtMost) {
  Verdict verdict = Bar(0.1);
  verdict.floor = {0.011, "too high"};
  EXPECT_DEATH(Judge(verdict, {1, 0.1}), "floor");
}

TEST(JudgeLevels, TheFinestMayHaveABarOfItsOwn) {
  Verdict verdict = Bar(1e-3);
  verdict.finer_bar = 3e-4;
  EXPECT_TRUE(Judge(verdict, {4e-3, 9e-4, 2.9e-4}).holds);
  EXPECT_FALSE(Judge(verdict, {4e-3, 9e-4, 3.1e-4}).holds);
  EXPECT_TRUE(Judge(verdict, {4e-3, 9e-4}).holds) << "it was not run";
}

TEST(JudgeLevels, ARunThatBrokeDownOpensErrorsAndBounds) {
  for (const MetricKind kind : {MetricKind::kError, MetricKind::kBounded}) {
    EXPECT_FALSE(Judge(Bar(1, kind), {kBroken, 0.25, 0.0625}).holds) << "a coarse one, too";
    EXPECT_FALSE(Judge(Bar(1, kind), {1, 0.25, std::nan("")}).holds);
  }
}

TEST(JudgeLevels, WhatIsBoundedMayNotGrowByMoreThanSeedsDo) {
  const Verdict verdict = Bar(1, MetricKind::kBounded);
  const std::vector<double> seeds = {0.18, 0.19, 0.2, 0.21, 0.22};  // of standard deviation 0.0158
  EXPECT_TRUE(Judge(verdict, {0.2, 0.1, 0.2}, seeds).holds) << "it need not fall";
  EXPECT_TRUE(Judge(verdict, {0.2, 0.22, 0.244}, seeds).holds);
  EXPECT_FALSE(Judge(verdict, {0.2, 0.2, 0.246}, seeds).holds) << "by 2.9 standard deviations";
  EXPECT_FALSE(Judge(verdict, {0.2, 0.2, 0.201}).holds) << "what does not depend on the seed may not grow at all";
  EXPECT_FALSE(Judge(verdict, {1.1, 0.9, 0.8}, seeds).holds) << "the bar is that of all levels";
  EXPECT_FALSE(Judge(verdict, {0.2, 0.2}, seeds).order);
}

TEST(JudgeLevels, OtherKindsAreHeldAgainstTheirBarsAtOneResolution) {
  for (const MetricKind kind : {MetricKind::kRatio, MetricKind::kInvariant, MetricKind::kBand, MetricKind::kPrice}) {
    Verdict verdict = Bar(0.5, kind);
    verdict.value = -0.5;
    EXPECT_TRUE(Judge(verdict, {-0.5}).holds);
    verdict.value = 0.51;
    EXPECT_FALSE(Judge(verdict, {0.51}).holds);
    verdict.value = std::nan("");
    EXPECT_FALSE(Judge(verdict, {verdict.value}).holds);
  }
}

}  // namespace
}  // namespace sph
