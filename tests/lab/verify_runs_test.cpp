// A case is run at the resolutions that its kinds of metrics take, and no more.
#include "lab/verify_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes/build.hpp"

namespace sph {
namespace {

const VerificationCase& Case(const std::string& name) {
  return *std::ranges::find(AllVerificationCases(), name, &VerificationCase::name);
}

std::vector<std::size_t>& Runs() {
  static std::vector<std::size_t> runs;  // numbers of particles
  return runs;
}

/// An error of second order, and what a tenth of a spacing of disorder makes of a bound.
std::vector<Verdict> Pretend(ParticleSystemSPH& system) {
  Runs().push_back(system.State().Size());
  const double n = static_cast<double>(system.State().Size());
  const double disorder = system.State().x.front() - std::floor(system.State().x.front());
  return {{.metric = "an error", .value = -1 / n, .bar = 1, .reference = "", .promise = {2, "of second order"}},
          {.metric = "a bound", .value = disorder, .bar = 1, .reference = "", .kind = MetricKind::kBounded},
          {.metric = "a time", .value = n, .bar = 1e6, .reference = "", .kind = MetricKind::kPrice}};
}

std::vector<Verdict> PretendOnce(ParticleSystemSPH& system) { return {Pretend(system)[2]}; }

VerificationCase PretendedCase() {
  VerificationCase of = Case("still-water");
  of.request.particles = 720;
  of.measure = &Pretend;
  return of;
}

TEST(RunCase, GoesUpTheLadderAndThroughSeedsAtItsFoot) {
  Runs().clear();
  const CaseResult result = RunCase(PretendedCase(), {true, 1});
  // 20 to 9: 180 times a square.
  EXPECT_EQ(Runs(), (std::vector<std::size_t>{720, 180, 180, 180, 180, 180, 180, 2880}));
  EXPECT_EQ(result.particles, 720u);
  ASSERT_EQ(result.metrics.size(), 3u);
  const Judged& error = result.metrics[0];
  ASSERT_EQ(error.levels.size(), 3u);
  EXPECT_EQ(error.levels.front().particles, 180u);
  EXPECT_EQ(error.levels.back().value, -1.0 / 2880) << "with its sign";
  EXPECT_NEAR(*error.order, 2, 1e-12);
  EXPECT_TRUE(error.holds);
  EXPECT_EQ(result.metrics[1].levels.size(), 3u);
  ASSERT_EQ(result.metrics[2].levels.size(), 1u) << "a price is that of the case's own resolution";
  EXPECT_EQ(result.metrics[2].levels.front().value, 720);
}

TEST(RunCase, RunsOnceWhatNeedsNoLadder) {
  Runs().clear();
  VerificationCase of = PretendedCase();
  of.measure = &PretendOnce;
  RunCase(of, {true, 1});
  EXPECT_EQ(Runs(), std::vector<std::size_t>{720});
}

TEST(LadderOf, IsTheLastTwoUpToTheOwnOrWhole) {
  VerificationCase of = Case("taylor-green");
  EXPECT_EQ(LadderOf(of, false), (std::vector<std::size_t>{625, 2500}));
  EXPECT_EQ(LadderOf(of, true), (std::vector<std::size_t>{625, 2500, 10'000}));
  of.shares = {1.0 / 25, 0.25, 1};
  EXPECT_EQ(LadderOf(of, false), (std::vector<std::size_t>{625, 2500}));
  EXPECT_EQ(LadderOf(of, true), (std::vector<std::size_t>{100, 625, 2500}));
}

TEST(LadderOf, GoesUpAndHasTheCasesOwn) {
  for (const VerificationCase& of : AllVerificationCases()) {
    for (const bool whole : {false, true}) {
      const auto numbers = LadderOf(of, whole);
      EXPECT_EQ(numbers.size(), whole ? of.shares.size() : 2u) << of.name;
      EXPECT_TRUE(std::ranges::is_sorted(numbers, std::less_equal<>())) << of.name;
      EXPECT_NE(std::ranges::find(numbers, LoadScene(of.request).base.fluid.particles), numbers.end()) << of.name;
    }
  }
}

TEST(SceneOf, HasWhatSettingsCannotSay) {
  const Scene tilted = SceneOf(Case("rest-tilted"), 500, 1);
  EXPECT_EQ(tilted.base.walls.size(), 4u);
  EXPECT_EQ(tilted.base.fluid.particles, 500u);
  EXPECT_EQ(SceneOf(Case("operators"), 625, 1).base.time_step, 1e-9);
}

}  // namespace
}  // namespace sph
