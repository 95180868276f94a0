// The comparisons of with and without: whose turn it is, what they compare, and that leaving out changes no result.
#include "lab/skips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lab/skips_report.hpp"

namespace sph {
namespace {

TEST(Skip, IsMeasuredInTurns) {
  std::string turns;
  const auto arm = [&](char letter, double time) {
    return Arm{std::string(1, letter), [&turns, letter, time] { return turns += letter, time; }, [] { return 0.5; }};
  };
  const SkipResult result = Measure({"mechanism", "s", arm('a', 6), arm('b', 2), "error"}, 3);
  EXPECT_EQ(turns, "ababab");
  EXPECT_EQ(result.repetitions, 3);
  EXPECT_EQ(result.with.least, 6);
  EXPECT_EQ(result.without.greatest, 2);
  EXPECT_EQ(result.Ratio(), 3);
  EXPECT_EQ(result.error_with, 0.5);
}

const std::vector<SkipResult>& TinyResults() {
  static const std::vector<SkipResult> results = [] {
    std::vector<SkipResult> all;
    for (const auto& make : SkipComparisons(400)) all.push_back(Measure(make(), 1));
    return all;
  }();
  return results;
}

TEST(Skips, AreEveryMechanism) {
  std::set<std::string> mechanisms;
  for (const SkipResult& r : TinyResults()) mechanisms.insert(r.mechanism);
  EXPECT_EQ(mechanisms, (std::set<std::string>{"diagnostics", "drawing on no screen", "guard", "masses",
                                               "neighbour lists", "time step of scene dam-break",
                                               "viscosity in solver mueller", "walls", "walls looked at"}));
}

TEST(Skips, HaveTheErrorBesideTheTime) {
  for (const SkipResult& r : TinyResults()) {
    EXPECT_GT(r.with.least, 0) << r.mechanism;
    EXPECT_GT(r.without.least, 0) << r.mechanism;
    // Densities in float; the dam's deepest particle is a part of a spacing deep, whichever step; with a viscosity that
    // does nothing, particles end where they end without, but for the round-off of floats.
    const double bar = r.mechanism.starts_with("time step") ? 0.5 : r.mechanism.starts_with("viscosity") ? 1e-3 : 2e-6;
    EXPECT_LT(r.error_with, bar) << r.mechanism;
    EXPECT_LT(r.error_without, bar) << r.mechanism;
  }
}

TEST(SkipsCsv, HasAValueForEveryColumn) {
  const std::string csv = SkipsAsCsv(TinyResults());
  EXPECT_TRUE(csv.starts_with("mechanism,with,without,unit,"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), TinyResults().size() + 1);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','), 14 * std::count(csv.begin(), csv.end(), '\n'));
  EXPECT_EQ(csv.find(",,"), std::string::npos);
}

}  // namespace
}  // namespace sph
