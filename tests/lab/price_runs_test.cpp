// Time and error come from the same runs: how often they are repeated, what is left out, what breaks down.
#include "lab/price_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scenes/build.hpp"

namespace sph {
namespace {

std::map<std::size_t, int>& Runs() {
  static std::map<std::size_t, int> runs;  // by number of particles
  return runs;
}

/// A hundred steps; an error of 1/N in two units, and a run time that is none.
std::vector<Verdict> Pretend(ParticleSystemSPH& system) {
  const std::size_t n = system.State().Size();
  ++Runs()[n];
  for (int k = 0; k < 100 && !system.Trouble(); ++k) system.Step();
  const double error = system.Trouble() ? kBroken : 1 / static_cast<double>(n);
  return {{"an error [m]", 7 * error, 1, "", RelativeError{"an error", error}},
          {"another", 2 * error, 1, ""},
          {"seconds", 5, 1, "", {}, MetricKind::kPrice}};
}

VerificationCase PretendedCase(std::vector<std::string> settings = {}) {
  SceneRequest request;
  request.scene = "toy-star";
  request.settings = std::move(settings);
  request.particles = 320;
  return {"pretended", "a toy star", false, request, &Pretend};
}

bool Never() { return false; }

TEST(Prices, HaveEverySolverPrecisionAndStepFromCoarseToFine) {
  const PricedCase priced = MeasurePrices(PretendedCase(), {.quick = true}, &Never);
  EXPECT_EQ(priced.metrics, (std::vector<std::string>{"greatest error", "an error", "another"}));
  std::map<std::string, std::vector<std::size_t>> particles;
  for (const PricedRun& run : priced.runs) {
    ASSERT_TRUE(run.Held()) << NameOf(run.method) << ": " << run.note;
    particles[NameOf(run.method)].push_back(run.particles);
    EXPECT_GT(run.least, 0);
    EXPECT_EQ(run.steps, 100);
    EXPECT_EQ(run.repetitions, 1);
    EXPECT_EQ(run.errors[0], run.errors[2]);
    EXPECT_EQ(run.errors[1], 1 / static_cast<double>(run.particles));
    EXPECT_EQ(run.errors[2], 2 / static_cast<double>(run.particles));
  }
  EXPECT_EQ(particles.size(), 18u);
  EXPECT_TRUE(particles.contains("delta float adaptive") && particles.contains("mueller double half"));
  for (const auto& [name, numbers] : particles) {
    EXPECT_EQ(numbers, (std::vector<std::size_t>{5, 10, 20, 40, 80})) << name;
  }
}

TEST(Prices, RepeatShortRunsAndLeaveOutLongOnes) {
  Runs().clear();
  const PricedCase priced = MeasurePrices(PretendedCase(), {.longest = 1e-7}, &Never);
  for (const PricedRun& run : priced.runs) {
    const bool coarsest = run.particles == 5;
    EXPECT_EQ(run.repetitions, coarsest ? 4 : 0);
    EXPECT_EQ(run.note.starts_with("left out: would take about "), !coarsest) << run.note;
    EXPECT_LE(run.least, run.greatest);
  }
  EXPECT_EQ(Runs(), (std::map<std::size_t, int>{{5, 18 * 4}}));
}

TEST(Prices, SayHowARunBrokeDown) {
  // A step of a second; delta, to whose scene the settings belong, takes it, others the file's.
  VerificationCase of = PretendedCase({"method.step=fixed", "method.time_step=1"});
  of.request.solver = "delta";
  const PricedCase priced = MeasurePrices(of, {.quick = true}, &Never);
  int broken = 0;
  for (const PricedRun& run : priced.runs) {
    if (run.Held() || run.note.starts_with("left out: ")) continue;
    ++broken;
    EXPECT_EQ(run.method.solver, "delta");
    ASSERT_TRUE(run.note.starts_with("broke down: ")) << run.note;
    EXPECT_EQ(run.errors[0], kBroken);
  }
  EXPECT_GT(broken, 0);
}

TEST(Prices, EndWhenInterrupted) {
  int asked = 0;
  const PricedCase priced = MeasurePrices(PretendedCase(), {.quick = true}, [&] { return ++asked > 3; });
  EXPECT_EQ(priced.runs.size(), 3u);
}

/// An error that never falls.
std::vector<Verdict> Stuck(ParticleSystemSPH& system) {
  system.Step();
  return {{"an error", 0.5, 1, ""}};
}

TEST(Prices, AreNotSoughtWhereErrorsFallNoMoreButForTheCasesOwnNumber) {
  VerificationCase of = PretendedCase();
  of.measure = &Stuck;
  const PricedCase priced = MeasurePrices(of, {}, &Never);
  for (const PricedRun& run : priced.runs) {
    const bool ran = run.particles <= 40 || run.particles == 320;
    EXPECT_EQ(run.Held(), ran) << run.particles;
    EXPECT_EQ(run.note, ran ? "" : "left out: errors fall no more");
  }
}

PricedRun RunOf(const std::string& solver, double seconds, double error) {
  PricedRun run;
  run.method.solver = solver;
  run.repetitions = 1;
  run.least = seconds;
  run.errors = {0.5 * error, error};
  return run;
}

TEST(ErrorsOf, BeginWithTheGreatestOfSeveral) {
  const Verdict first{"a", -0.1, 1, ""}, second{"b [m]", 7, 1, "", RelativeError{"b", 0.2}},
      time{"s", 9, 1, "", {}, MetricKind::kPrice};
  EXPECT_EQ(ErrorsOf({first, second, time}), (std::vector{0.2, 0.1, 0.2}));
  EXPECT_EQ(ErrorsOf({second, time}), (std::vector{0.2}));
}

/// Goes on for ever without what is measured.
std::vector<Verdict> Nowhere(ParticleSystemSPH&) { return {{"an error", kBroken, 1, ""}}; }

TEST(Prices, AreNoneWithoutAnythingToMeasure) {
  VerificationCase of = PretendedCase();
  of.measure = &Nowhere;
  const PricedCase priced = MeasurePrices(of, {.quick = true}, &Never);
  for (const PricedRun& run : priced.runs) {
    EXPECT_FALSE(run.Held());
    EXPECT_EQ(run.note, "went another way: nothing to measure");
  }
}

TEST(Prices, AreNotSoughtForLongWhereThereIsNothingToMeasure) {
  VerificationCase of = PretendedCase();
  of.measure = &Nowhere;
  const PricedCase priced = MeasurePrices(of, {.longest = 1e-9}, &Never);
  EXPECT_EQ(std::ranges::count(priced.runs, 1, &PricedRun::repetitions), 18) << "the coarsest of each method";
}

TEST(PricesOf, AreOfTheRunsThatHeldAndAreWanted) {
  PricedCase of;
  of.runs = {RunOf("delta", 3, 0.2), RunOf("paper", 4, 0.4), RunOf("delta", 5, kBroken)};
  of.runs.back().note = "broke down";
  const auto prices = PricesOf(of, 1, [](const PricedRun& run) { return run.method.solver == "delta"; });
  ASSERT_EQ(prices.size(), 1u);
  EXPECT_EQ(prices[0].seconds, 3);
  EXPECT_EQ(prices[0].error, 0.2);
}

}  // namespace
}  // namespace sph
