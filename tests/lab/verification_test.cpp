// Verification cases: the quick ones hold what they are said to hold, and a run that breaks down holds nothing.
#include "lab/verification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lab/verify_runs.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

TEST(Verdict, IsWithinItsBarWithEitherSignAndNeverWithoutANumber) {
  const auto within = [](double value) { return Verdict{"m", value, 0.5, ""}.WithinBar(); };
  EXPECT_TRUE(within(0) && within(0.5) && within(-0.5));
  EXPECT_FALSE(within(0.51) || within(-0.51));
  EXPECT_FALSE(within(kBroken) || within(-kBroken) || within(std::nan("")));
}

TEST(Verification, CasesHaveNamesOfTheirOwnAndScenesThatExist) {
  std::set<std::string> names;
  for (const VerificationCase& of : AllVerificationCases()) {
    EXPECT_TRUE(names.insert(of.name).second) << of.name;
    EXPECT_FALSE(of.what.empty()) << of.name;
    EXPECT_EQ(LoadScene(of.request).solver, "delta") << of.name;
  }
}

/// With so few particles that a run takes no time, and with settings.
Scene ToyScene(const VerificationCase& of, std::size_t particles, const std::vector<std::string>& settings = {}) {
  VerificationCase toy = of;
  toy.request.settings.insert(toy.request.settings.end(), settings.begin(), settings.end());
  return SceneOf(toy, particles, 0);
}

TEST(Verification, ARunThatBreaksDownHoldsNothing) {
  int broken = 0;
  for (const VerificationCase& of : AllVerificationCases()) {
    if (of.name == "operators") continue;  // nothing moves in it
    const double step = LoadScene(of.request).base.time_step;
    const std::string longer = "method.time_step=" + std::to_string(20 * step);
    Scene scene = ToyScene(of, 600, {longer, "method.step=fixed"});  // breaks down as soon as more would
    scene.settling = {};                                             // which would end with an error of its own
    const auto system = MakeSystem(scene);
    for (const Verdict& verdict : of.measure(*system)) {
      if (!system->Trouble()) continue;
      EXPECT_FALSE(verdict.WithinBar()) << of.name << ": " << verdict.metric << " = " << verdict.value;
    }
    broken += system->Trouble().has_value();
  }
  EXPECT_GE(broken, 10);  // damped stars bear even this step
}

TEST(Verification, SlowEveryCaseSaysOfEveryMetricByWhatRuleItIsJudged) {
  for (const VerificationCase& of : AllVerificationCases()) {
    SCOPED_TRACE(of.name);
    const auto system = MakeSystem(ToyScene(of, of.name.starts_with("poiseuille") ? 384 : 600));
    for (const Verdict& verdict : of.measure(*system)) {
      SCOPED_TRACE(verdict.metric);
      EXPECT_LE(verdict.metric.size(), 58u) << "as wide as the table's column";
      EXPECT_FALSE(verdict.reference.empty());
      EXPECT_GT(verdict.bar, 0);
      EXPECT_FALSE(std::isnan(verdict.value)) << "few particles, too, can be measured";
      if (verdict.kind != MetricKind::kError) continue;
      EXPECT_GE(verdict.promise.least, 0.5 * verdict.promise.order);
      EXPECT_STRNE(verdict.promise.why, "");
      const Floor floor = verdict.floor.value_or(Floor{0, "none"});
      EXPECT_STRNE(floor.why, "");
      EXPECT_LE(floor.value, 0.1 * verdict.bar);
    }
  }
}

/// A case with so many particles, or its own, and with settings.
std::vector<Verdict> Measure(const std::string& name, std::optional<std::size_t> particles = {},
                             const std::vector<std::string>& settings = {}) {
  const VerificationCase& of = *std::ranges::find(AllVerificationCases(), name, &VerificationCase::name);
  const std::size_t own = LoadScene(of.request).base.fluid.particles;
  const auto system = MakeSystem(ToyScene(of, particles.value_or(own), settings));
  return of.measure(*system);
}

TEST(Verification, SlowCasesWithMirrorsHoldTheirBars) {
  for (const Verdict& verdict : Measure("measured-front")) {
    if (verdict.metric == "that delay in T, Martin & Moyce") continue;  // open: 0.33, the bar is 0.29
    EXPECT_TRUE(verdict.WithinBar()) << verdict.metric;
  }
}

TEST(Verification, SlowFlowBetweenPlatesOfParticlesIsRightToAboutAHundredth) {
  // 0.0106, their velocities being smoothed; 0.0003 with mirrors. Elsewhere 0.002 to 0.0069.
  EXPECT_LT(Measure("poiseuille", {}, {"walls.kind=particles"})[0].value, 0.012);
}

TEST(Verification, SlowAStandingWaveOfFewParticlesDecaysAboutAsItShouldIfItsSurfaceIsFreeOfStress) {
  // 0.146 and 0.0127 with 15 particles in the depth, 0.103 and 0.0052 with 20, 0.022 and 0.0035 with 50.
  const auto stress = Measure("standing-wave", 450);
  EXPECT_LT(std::abs(stress[0].value), 0.18) << stress[0].metric;
  EXPECT_LT(std::abs(stress[1].value), 0.016) << stress[1].metric;
  EXPECT_GT(std::abs(Measure("standing-wave", 450, {"method.viscous_form=laplacian"})[0].value),
            0.22);  // 0.268: too slow
}

TEST(Verification, SlowAWallFeelsWhatWasMeasuredIfTheFloorBrakesTheWater) {
  const auto braked = Measure("wall-impact");
  ASSERT_EQ(braked.size(), 3u);
  EXPECT_TRUE(braked[1].WithinBar()) << braked[1].value;
  EXPECT_LT(braked[2].value, 0.105);  // the impulse, open: 0.1005, the bar is 0.1
  const auto slipping = Measure("wall-impact", {}, {"walls.layer_viscosity=0"});
  EXPECT_GT(std::abs(slipping[2].value), std::abs(braked[2].value)) << "the impulse";
  EXPECT_GT(slipping[1].value, braked[1].value);
}

TEST(Verification, SlowTheFrontWithoutFrictionIsAtTheWallWhenItShould) {
  EXPECT_LT(std::abs(Measure("wall-arrival", 3200)[0].value), 0.045);  // 0.037, and less with more particles
}

/// Rows of the quick part that are open, by the beginning of their metrics, as README says.
const std::multimap<std::string, std::string> kOpen = {
    {"graded-star", "mean square error"},
    {"elliptic-star", "place of all"},
    {"operators", "pressure force, lattice"},
    {"elliptic-drop", "long axis"},
    {"elliptic-drop", "kinetic energy"},
    {"still-water", "L2 of pressure"},
    {"wall-particles", "L2 of pressure"},
    {"wall-particles", "kinetic energy"},
    {"water-column", "front"},
    {"capillary-drop", "period"},
    {"capillary-drop", "mean pressure"},
};

TEST(Verification, SlowQuickCasesHoldByTheRulesOfTheirKindsButForThoseThatAreOpen) {
  for (const VerificationCase& of : AllVerificationCases()) {
    if (of.slow) continue;
    for (const Judged& metric : RunCase(of, {}).metrics) {
      if (metric.verdict.kind == MetricKind::kPrice) continue;  // of a machine that does other things
      // Round-off decides when the lattice there lets go, and so by how much its tiny energy grows: within its bar.
      if (of.name == "rest-odd-width" && metric.verdict.metric.starts_with("kinetic energy")) {
        EXPECT_TRUE(metric.verdict.WithinBar()) << metric.verdict.value;
        continue;
      }
      const auto [first, last] = kOpen.equal_range(of.name);
      const bool open =
          std::any_of(first, last, [&](const auto& row) { return metric.verdict.metric.starts_with(row.second); });
      EXPECT_EQ(metric.holds, !open) << of.name << ": " << metric.verdict.metric << " = " << metric.verdict.value
                                     << ", order " << metric.order.value_or(0);
    }
  }
}

}  // namespace
}  // namespace sph
