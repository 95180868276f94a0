// What no run beats, what it costs to reach an error, and orders of convergence.
#include "lab/frontier.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Frontier, IsInTheOrderOfTimeAndLeavesOutWhatIsBeaten) {
  const std::array<Price, 5> runs = {Price{4, 0.1}, {1, 0.4}, {2, 0.5}, {2, 0.2}, {8, 0.1}};
  EXPECT_EQ(Frontier(runs), (std::vector<std::size_t>{1, 3, 0}));
}

TEST(Frontier, LeavesOutWhatIsHardlyBetter) {
  const std::array<Price, 4> runs = {Price{1, 0.1}, {2, 0.099}, {3, 0.0979}, {4, 0.05}};
  EXPECT_EQ(Frontier(runs), (std::vector<std::size_t>{0, 2, 3}));
}

TEST(Frontier, LeavesOutWhatBrokeDownOrHasNoLogarithm) {
  const std::array<Price, 5> runs = {Price{1, kInfinity}, {2, std::nan("")}, {3, 0}, {0, 1}, {4, 0.1}};
  EXPECT_EQ(Frontier(runs), (std::vector<std::size_t>{4}));
}

RC_GTEST_PROP(Frontier, IsBeatenByNoRunAndBeatsAllOthers, ()) {
  const auto grid = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(1, 9), rc::gen::inRange(1, 9)));
  std::vector<Price> runs;
  for (const auto& [seconds, error] : grid) runs.push_back({1.0 * seconds, 1.0 * error});
  const auto frontier = Frontier(runs);
  const auto beats = [&](const Price& a, const Price& b) {
    return a.seconds <= b.seconds && a.error <= b.error && (a.seconds < b.seconds || a.error < b.error);
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool beaten = std::ranges::any_of(runs, [&](const Price& other) { return beats(other, runs[i]); });
    const bool there = std::ranges::any_of(
        frontier, [&](std::size_t k) { return runs[k].seconds == runs[i].seconds && runs[k].error == runs[i].error; });
    RC_ASSERT(there != beaten);
  }
}

TEST(TimeToReach, IsExactWhereErrorFallsAsAPowerOfTime) {
  std::vector<Price> runs;
  for (const double t : {0.5, 3.0, 11.0, 100.0}) runs.push_back({t, std::pow(t, -0.7)});
  for (const double error : {1.2, 0.5, 0.1, 0.04}) {
    const Reach reach = TimeToReach(runs, error);
    EXPECT_EQ(reach.kind, Reach::Kind::kMeasured);
    EXPECT_NEAR(reach.seconds, std::pow(error, -1 / 0.7), 1e-12 * reach.seconds);
  }
}

TEST(TimeToReach, IsABoundWhereTheQuickestRunIsGoodEnoughAndNothingWhereNoneIs) {
  const std::array<Price, 2> runs = {Price{2, 0.1}, {4, 0.01}};
  EXPECT_EQ(TimeToReach(runs, 0.3).kind, Reach::Kind::kAtMost);
  EXPECT_EQ(TimeToReach(runs, 0.3).Text(), "<= 2");
  EXPECT_EQ(TimeToReach(runs, 0.01).Text(), "4");
  EXPECT_EQ(TimeToReach(runs, 0.009).Text(), "not reached");
  EXPECT_EQ(TimeToReach({}, 0.1).kind, Reach::Kind::kNever);
}

TEST(FittedOrder, IsTheExponentOfAPower) {
  const std::vector<double> spacings = {0.1, 0.04, 0.01};
  std::vector<double> errors;
  for (const double dx : spacings) errors.push_back(3 * std::pow(dx, 1.9));
  EXPECT_NEAR(FittedOrder(spacings, errors).value(), 1.9, 1e-12);
}

TEST(FittedOrder, TakesThreeErrorsThatAreNumbers) {
  const std::array<double, 3> spacings = {0.4, 0.2, 0.1};
  EXPECT_FALSE(FittedOrder(std::array{0.4, 0.2}, std::array{0.4, 0.2}));
  EXPECT_FALSE(FittedOrder(spacings, std::array{0.4, 0.2, kInfinity}));
  EXPECT_FALSE(FittedOrder(spacings, std::array{0.4, 0.0, 0.1}));
  EXPECT_TRUE(FittedOrder(spacings, std::array{0.4, 0.2, 0.1}));
}

}  // namespace
}  // namespace sph
