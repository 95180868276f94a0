// A case goes to every solver that can run it, at resolutions that its lattice fills.
#include "lab/price_methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes/build.hpp"

namespace sph {
namespace {

const VerificationCase& Case(const std::string& name) {
  return *std::ranges::find(AllVerificationCases(), name, &VerificationCase::name);
}

Prepared PrepareCase(const std::string& name, const Method& method, std::size_t particles) {
  return Prepare(Case(name), method, particles, 1);
}

TEST(Prepare, GivesTheOwnSolverTheCasesScene) {
  const Scene scene = LoadScene(Case("taylor-green").request);
  const auto prepared = PrepareCase("taylor-green", {"delta"}, 2500);
  ASSERT_TRUE(prepared.system);
  EXPECT_EQ(prepared.system->parameters_sph.smoothing_length, scene.sph.smoothing_length);
  EXPECT_EQ(prepared.system->parameters.time_step, scene.base.time_step);
  EXPECT_FALSE(prepared.system->parameters.adaptive_step);
  EXPECT_EQ(prepared.system->parameters_sph.precision, Precision::kDouble);
}

TEST(Prepare, ChoosesStepAndPrecision) {
  const double fixed = PrepareCase("elliptic-drop", {"delta"}, 700).system->parameters.time_step;
  const auto half = PrepareCase("elliptic-drop", {"delta", StepChoice::kHalf, Precision::kFloat}, 700);
  EXPECT_EQ(half.system->parameters.time_step, 0.5 * fixed);
  EXPECT_EQ(half.system->parameters_sph.precision, Precision::kFloat);
  // Fixed, too, where the scene has an adaptive step.
  EXPECT_FALSE(PrepareCase("water-column", {"delta"}, 800).system->parameters.adaptive_step);
  EXPECT_TRUE(PrepareCase("water-column", {"delta", StepChoice::kAdaptive}, 800).system->parameters.adaptive_step);
}

TEST(Prepare, GivesThePaperItsOwnStar) {
  const auto prepared = PrepareCase("toy-star", {"paper"}, 3000);
  ASSERT_TRUE(prepared.system);
  EXPECT_NEAR(prepared.system->parameters_sph.smoothing_length, 0.04 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(prepared.system->parameters.time_step, 0.004 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(prepared.system->KernelName(), "cubic spline");
}

TEST(Prepare, SaysWhatASolverDoesNotKnow) {
  EXPECT_EQ(PrepareCase("taylor-green", {"paper"}, 2500).why_not, "it has no viscosity");
  EXPECT_EQ(PrepareCase("poiseuille", {"mueller"}, 2400).why_not, "fluid does not stick to its walls");
  EXPECT_NE(PrepareCase("taylor-green", {"delta"}, 100).why_not.find("periodic.box"), std::string::npos);
}

TEST(Prepare, ReplacesMirrorsByWallsThatStopAFallingParticleWithinHalfASpacing) {
  const auto prepared = PrepareCase("still-water", {"paper"}, 720);
  ASSERT_TRUE(prepared.system) << prepared.why_not;
  WallParameters wall = prepared.system->parameters.wall;
  EXPECT_EQ(wall.kind, WallKind::kPenalty);
  wall.damping = 0;  // without which it goes deepest
  const double speed = std::sqrt(2 * 1.0 * 0.9);
  double deepest = 0;
  for (double t = 0; t < 0.2; t += 1e-4) deepest = std::max(deepest, PenetrationAfter(wall, speed, t).depth);
  EXPECT_NEAR(deepest, 0.5 * prepared.system->InitialSpacing(), 1e-4);
}

TEST(Prepare, GivesOtherSolversAStepThatTheyBear) {
  const auto prepared = PrepareCase("taylor-green", {"mueller"}, 2500);
  ASSERT_TRUE(prepared.system) << prepared.why_not;
  EXPECT_LE(prepared.system->parameters.time_step, LargestStep(prepared.system->StepLimits()) * (1 + 1e-9));
  EXPECT_NEAR(prepared.system->Support(), 1.75 * 0.02, 1e-9);
}

TEST(Resolutions, GoUpAndHaveTheCasesOwn) {
  for (const VerificationCase& of : AllVerificationCases()) {
    if (!of.in_bench) continue;
    const auto numbers = Resolutions(of);
    EXPECT_TRUE(std::ranges::is_sorted(numbers, std::less_equal<>())) << of.name;
    EXPECT_GE(numbers.size(), 5u) << of.name;
    const std::size_t own = LoadScene(of.request).base.fluid.particles;
    EXPECT_NE(std::ranges::find(numbers, own), numbers.end()) << of.name;
  }
}

TEST(Resolutions, FillBoxesWithRowsAndColumns) {
  for (const std::size_t n : Resolutions(Case("taylor-green"))) {
    const double columns = std::sqrt(static_cast<double>(n));
    EXPECT_EQ(columns, std::round(columns)) << n;
  }
  // 20 to 9: 180 times a square.
  for (const std::size_t n : Resolutions(Case("still-water"))) {
    const double columns = std::sqrt(static_cast<double>(n) / 180);
    EXPECT_NEAR(columns, std::round(columns), 1e-9) << n;
  }
}

}  // namespace
}  // namespace sph
