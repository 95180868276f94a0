// The benchmark of speed measures what it says: its flows, cases, errors and limit. No test here depends on how fast
// the machine is.
#include "lab/speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "base/instruction_set.hpp"
#include "lab/skips_report.hpp"
#include "lab/speed_report.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

std::unique_ptr<ParticleSystemSPH> Warm(Flow flow, std::size_t particles) {
  auto system = MakeSystem(SpeedScene(flow, particles, Precision::kDouble));
  WarmUp(*system, flow);
  return system;
}

double SoundSpeed(const ParticleSystemSPH& system) {
  return std::get<Tait>(system.parameters_sph.equation_of_state).SoundSpeed(1000);
}

TEST(SpeedFlow, TankIsNearlyAtRest) {
  const auto system = Warm(Flow::kTank, 2000);
  const Diagnostics d = Diagnose(*system);
  EXPECT_LT(d.max_speed, 0.06 * SoundSpeed(*system));
  EXPECT_NEAR(d.density.mean, 1000, 10);
  EXPECT_EQ(d.outside, 0U);
  EXPECT_GT(system->parameters.motion_damping * TimeScale(), 7.9) << "the flow's own, not the warm-up's";
}

TEST(SpeedFlow, CollapseIsMeasuredWhileTheWaterRuns) {
  const auto system = Warm(Flow::kCollapse, 2000);
  const Diagnostics d = Diagnose(*system);
  EXPECT_GT(d.bounds.x1, 1.2) << "the front has left the column";
  EXPECT_LT(d.bounds.x1, 3.9) << "and is not at the far wall";
  EXPECT_GT(d.max_speed, 1 / TimeScale()) << "faster than sqrt(g H)";
  EXPECT_EQ(d.outside, 0U);
}

TEST(SpeedFlow, SoundIsTenTimesAsFastAsShallowWater) {
  const auto system = MakeSystem(SpeedScene(Flow::kTank, 200, Precision::kDouble));
  EXPECT_NEAR(SoundSpeed(*system) * TimeScale(), 10, 1e-9);  // H = 1 m
  const double h = system->parameters_sph.smoothing_length;
  EXPECT_NEAR(h / system->InitialSpacing(), 1.3, 1e-9);
  EXPECT_NEAR(system->parameters.time_step * SoundSpeed(*system) / h, 0.4, 1e-9);
}

TEST(SpeedCases, HaveEverySetPrecisionFlowAndNumberOfThreads) {
  std::set<std::string> sets;
  std::set<std::size_t> tanks;
  bool collapse_in_float = false;
  for (const SpeedCase& of : SpeedCases(false)) {
    sets.insert(of.instruction_set);
    if (of.flow == Flow::kTank) tanks.insert(of.particles);
    EXPECT_EQ(of.threads, (std::vector<int>{1, 2}));
    collapse_in_float |= of.precision == Precision::kFloat && of.flow == Flow::kCollapse;
  }
  const auto available = AvailableInstructionSets();
  EXPECT_EQ(sets, std::set<std::string>(available.begin(), available.end()));
  EXPECT_EQ(tanks, (std::set<std::size_t>{1000, 10'000, 100'000, 1'000'000, 4'000'000}));
  EXPECT_TRUE(collapse_in_float);
}

TEST(SpeedCases, OfAQuickRunAreAmongThoseOfTheWhole) {
  const auto whole = SpeedCases(false);
  for (const SpeedCase& of : SpeedCases(true)) {
    EXPECT_TRUE(std::any_of(whole.begin(), whole.end(), [&](const SpeedCase& other) {
      return other.flow == of.flow && other.particles == of.particles && other.precision == of.precision &&
             other.instruction_set == of.instruction_set && other.threads == of.threads;
    }));
  }
}

TEST(Spread, IsLeastMedianAndGreatest) {
  const Spread spread = SpreadOf({5, 1, 4, 2, 3});
  EXPECT_EQ(spread.least, 1);
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.greatest, 5);
}

/// Results of a tiny tank with every instruction set in both precisions.
const RatesOfThreads& Rates() {
  static const RatesOfThreads rates = MeasureVectorRates();
  return rates;
}

const std::vector<SpeedResult>& TinyResults() {
  static const std::vector<SpeedResult> results = [] {
    std::vector<SpeedResult> all;
    for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
      for (const std::string& set : AvailableInstructionSets()) {
        for (const SpeedResult& r : MeasureSpeed({Flow::kTank, 800, precision, set, {1, 2}, 1e4}, Rates())) {
          all.push_back(r);
        }
      }
    }
    return all;
  }();
  return results;
}

TEST(MeasureSpeed, FillsEveryField) {
  ASSERT_EQ(TinyResults().size(), 4 * AvailableInstructionSets().size());
  for (const SpeedResult& r : TinyResults()) {
    EXPECT_EQ(r.particles, 800U);
    EXPECT_GE(r.repetitions, 5);
    EXPECT_GE(r.steps, r.repetitions * 8);
    EXPECT_GT(r.ns.least, 0);
    EXPECT_LE(r.ns.least, r.ns.median);
    EXPECT_LE(r.ns.median, r.ns.greatest);
    for (const double pass : {r.grid_ns, r.density_ns, r.pressure_ns, r.integrate_ns}) EXPECT_GT(pass, 0);
    EXPECT_GE(r.walls_ns, 0) << "no particle need be behind one";
    EXPECT_LE(r.grid_ns + r.density_ns + r.pressure_ns + r.walls_ns + r.integrate_ns, r.ns.least);
    // On a lattice 20 others are in the support of 2.6 spacings; a particle at an edge has half of them.
    EXPECT_GT(r.neighbours, 16);
    EXPECT_LT(r.neighbours, 21);
    EXPECT_GE(r.steps_per_list, 1);
    EXPECT_GT(r.bytes, 100) << "ten numbers of state alone are 76 bytes";
  }
}

TEST(MeasureSpeed, AParticleTakesAtMostTwoHundredBytes) {
  for (const Flow flow : {Flow::kTank, Flow::kCollapse}) {
    for (const SpeedResult& r :
         MeasureSpeed({flow, 10'000, Precision::kFloat, AvailableInstructionSets().back(), {1}, 1e4}, Rates())) {
      EXPECT_LT(r.bytes, 200);
    }
  }
}

TEST(MeasureSpeed, HasTheErrorsOfItsPrecision) {
  for (const SpeedResult& r : TinyResults()) {
    const bool in_float = r.precision == Precision::kFloat;
    EXPECT_LT(r.errors.density, in_float ? 2e-6 : 1e-13);
    // An error of rho counts a hundredfold in water at rest, see FieldErrors.
    EXPECT_LT(r.errors.acceleration, in_float ? 2e-4 : 1e-11);
    EXPECT_GT(r.errors.density, in_float ? 1e-9 : 1e-18) << "the twin is another way to the same sum";
  }
}

TEST(MeasureSpeed, LeavesTheInstructionSetAsItWas) {
  const std::string before = InstructionSetInUse();
  MeasureSpeed({Flow::kTank, 100, Precision::kFloat, "baseline", {1}, 1e3}, {{1, {1, 1}}});
  EXPECT_EQ(InstructionSetInUse(), before);
}

TEST(ScalarTwin, SeesFieldsOfAnEarlierTime) {
  const auto system = Warm(Flow::kCollapse, 500);
  system->ComputeFields();
  EXPECT_LT(ErrorsAgainstScalarTwin(*system).density, 1e-13);
  EXPECT_LT(ErrorsAgainstScalarTwin(*system).acceleration, 1e-13);
  system->Step();
  EXPECT_GT(ErrorsAgainstScalarTwin(*system).density, 1e-4);
  EXPECT_GT(ErrorsAgainstScalarTwin(*system).acceleration, 1e-3);
}

TEST(SpeedLimit, IsWhatItsOperationsTakeAtTheMeasuredRate) {
  const VectorRates rates{80e9, 48e9};
  // 40 operations for each neighbour in float, 48 in double.
  EXPECT_NEAR(LeastSeconds(rates, Precision::kFloat, 20), 20 * 40 / 80e9, 1e-18);
  EXPECT_NEAR(LeastSeconds(rates, Precision::kDouble, 20), 20 * 48 / 48e9, 1e-18);
}

TEST(SpeedLimit, IsThatOfTheNeighboursAndThreadsMeasured) {
  for (const SpeedResult& r : TinyResults()) {
    EXPECT_GT(r.limit_ns, 0);
    EXPECT_DOUBLE_EQ(r.limit_ns, 1e9 * LeastSeconds(Rates().at(r.threads), r.precision, r.neighbours));
  }
}

TEST(SpeedCsv, HasAValueForEveryColumn) {
  const std::string csv = SpeedAsCsv(TinyResults());
  EXPECT_TRUE(csv.starts_with("flow,particles,threads,precision,instruction_set,"));
  std::size_t lines = 0;
  std::ptrdiff_t columns = 0;
  for (std::size_t begin = 0; begin < csv.size(); ++lines) {
    const std::size_t end = csv.find('\n', begin);
    const std::string line = csv.substr(begin, end - begin);
    const auto commas = std::count(line.begin(), line.end(), ',');
    if (lines == 0) columns = commas;
    EXPECT_EQ(commas, columns) << line;
    EXPECT_EQ(line.find(",,"), std::string::npos) << line;
    begin = end + 1;
  }
  EXPECT_EQ(lines, TinyResults().size() + 1);
  for (const char* column : {"least [ns]", "greatest [ns]", "limit [ns]", "neighbours", "memory [bytes]",
                             "density_error", "particle_steps_per_second [1/s]"}) {
    EXPECT_NE(csv.substr(0, csv.find('\n')).find(column), std::string::npos) << column;
  }
}

TEST(SpeedCsv, OfThisRepositoryIsOfThisProgram) {
  for (const auto& [file, columns] : {std::pair{"speed.csv", SpeedAsCsv({})}, {"skips.csv", SkipsAsCsv({})}}) {
    std::ifstream csv(std::string(SPHLAB_SOURCE_DIR "/assets/bench/") + file);
    std::string head;
    EXPECT_TRUE(std::getline(csv, head)) << file;
    EXPECT_EQ(head + "\n", columns) << file << " is to be measured anew";
  }
}

TEST(SpeedPlot, HasTheLimitsAboveTheCurvesThatTheyLimit) {
  const Plot plot = SpeedPlot(TinyResults());
  ASSERT_GE(plot.series.size(), 5U);
  for (const Series& series : plot.series) {
    EXPECT_EQ(series.x, std::vector<double>{800}) << series.name;
    EXPECT_EQ(series.line == Line::kDashed, series.name.starts_with("limit")) << series.name;
  }
  for (std::size_t k = 2; k < plot.series.size(); ++k) EXPECT_LT(plot.series[k].y[0], plot.series[0].y[0]);
  EXPECT_LT(plot.series[1].y[0], plot.series[0].y[0]) << "double has half the lanes";
  EXPECT_EQ(Omissions(plot), "");
}

}  // namespace
}  // namespace sph
