// The stability tests in their small versions hold their bars; what they are made of does what it says.
#include "lab/stress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "lab/known_keys.hpp"
#include "lab/random_scene.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

/// Keeps what a test finds.
class Findings final : public StressSink {
 public:
  void Row(const StressRow& row) override { rows.push_back(row); }
  void Figure(const std::string& name, const Plot& plot, const std::string& csv) override {
    figures[name] = csv;
    omissions += Omissions(plot);
  }
  void Note(const std::string&, unsigned) override { ++notes; }
  void Say(const std::string& text) override { said += text; }
  bool Stopped() const override { return notes > most_notes; }

  std::vector<StressRow> rows;
  std::map<std::string, std::string> figures;
  std::string omissions, said;
  int notes = 0;
  int most_notes = 1'000'000;
};

StressOptions Quick() {
  StressOptions options;
  options.quick = true;
  options.threads = 1;
  return options;
}

Findings FindingsOf(const std::string& name, const StressOptions& options = Quick()) {
  Findings findings;
  for (const StressTest& test : AllStressTests()) {
    if (test.name == name) test.run(options, findings);
  }
  return findings;
}

void ExpectAllHold(const Findings& findings) {
  EXPECT_FALSE(findings.rows.empty());
  for (const StressRow& row : findings.rows) {
    EXPECT_TRUE(row.Holds()) << row.what << ": " << row.metric << " = " << row.value << ", bar " << row.bar << "; "
                             << row.note;
  }
}

TEST(StressRow, HoldsUpToItsBarAndNeverWithoutANumber) {
  const auto holds = [](double value, double bar) { return StressRow{"", "", value, bar}.Holds(); };
  EXPECT_TRUE(holds(0, 0) && holds(0.5, 0.5) && holds(7, kNoBar));
  EXPECT_FALSE(holds(0.6, 0.5) || holds(-1, 0) || holds(std::nan(""), 1) || holds(kNoValue, kNoBar));
}

TEST(StressTests, HaveNamesOfTheirOwn) {
  std::vector<std::string> names;
  for (const StressTest& test : AllStressTests()) names.push_back(test.name);
  EXPECT_EQ(names, (std::vector<std::string>{"step-limit", "starts", "size", "length", "rough", "random"}));
}

TEST(GreatestThatHolds, FindsTheLimitFromBothSides) {
  for (const double limit : {1.1, 3.7, 100.0}) {
    const double found = GreatestThatHolds(1, 2, 1e-3, [&](double x) { return x <= limit; });
    EXPECT_LE(found, limit);
    EXPECT_GE(found, limit / 1.001);
  }
  EXPECT_EQ(GreatestThatHolds(1, 2, 1e-3, [](double) { return true; }), kNoValue);
}

TEST(FirstFlaw, NamesWhatMayNotBePrinted) {
  SceneRequest request;
  request.particles = 50;
  Scene scene = LoadScene(request);
  const auto sound = MakeSystem(scene);
  EXPECT_EQ(FirstFlaw(*sound), "");
  sound->parameters.time_step = std::nan("");
  EXPECT_EQ(FirstFlaw(*sound), "the step is nan");
  sound->parameters.time_step = 1;
  sound->parameters.gravity = {0, -std::numeric_limits<double>::infinity()};
  EXPECT_EQ(FirstFlaw(*sound).substr(0, 23), "the potential energy is");
}

TEST(Stress, SlowStepsAreStableUpToTheTheorysLimit) {
  const Findings findings = FindingsOf("step-limit");
  ExpectAllHold(findings);
  EXPECT_TRUE(findings.figures.contains("step-limit-lattice") && findings.figures.contains("step-limit-dam"));
}

TEST(Stress, SlowStartsHold) {
  const Findings findings = FindingsOf("starts");
  ExpectAllHold(findings);
  EXPECT_EQ(findings.rows.size(), 6u);
}

TEST(Stress, SlowDerivedWallsHoldWherePublishedOnesSinkIn) {
  const Findings findings = FindingsOf("size");
  ExpectAllHold(findings);
  std::map<std::string, std::vector<double>> deepest;
  for (const StressRow& row : findings.rows) {
    deepest[row.what.find("published") != std::string::npos ? "published" : "derived"].push_back(row.value);
  }
  ASSERT_EQ(deepest["published"].size(), 3u);
  EXPECT_GT(deepest["published"][2], 6 * deepest["published"][0]) << "24 times as many particles";
  EXPECT_LT(deepest["derived"][2], 3 * deepest["derived"][0]);
}

TEST(Stress, SlowLongRunsKeepWhatIsConserved) { ExpectAllHold(FindingsOf("length")); }

TEST(Stress, SlowRoughHandlingEndsWellOrWithACause) {
  const Findings findings = FindingsOf("rough");
  ExpectAllHold(findings);
  int unstable = 0;
  for (const StressRow& row : findings.rows) unstable += row.note.starts_with("unstable: ") ? 1 : 0;
  EXPECT_GT(unstable, 5) << "rough it was";
}

/// As quick as it is, from a seed that is the same every day.
StressOptions QuickFrom(std::uint64_t seed, long count) {
  StressOptions options = Quick();
  options.seed = seed;
  options.count = count;
  return options;
}

TEST(Stress, RandomScenesAreRefusedOrRun) {
  const Findings findings = FindingsOf("random", QuickFrom(1, 12));
  const std::string& note = findings.rows.at(0).note;
  EXPECT_FALSE(note.starts_with("0 ok")) << note;
  EXPECT_EQ(note.find(", 0 refused"), std::string::npos) << note;
  EXPECT_NE(findings.rows.at(0).what.find("seeds from 1 on"), std::string::npos) << findings.rows.at(0).what;
}

TEST(Stress, RandomScenesCanBeRepeatedOneByOne) {
  const std::string said = FindingsOf("random", QuickFrom(2, 1)).said;
  EXPECT_NE(said.find("title = \"random"), std::string::npos) << said;
  EXPECT_EQ(FindingsOf("random", QuickFrom(2, 1)).said, said);
  EXPECT_NE(FindingsOf("random", QuickFrom(4, 1)).said, said);
}

TEST(Stress, RandomScenesAreOthersEveryDay) {
  using namespace std::chrono;
  const auto seed = [](year_month_day day) { return SeedOfDay(sys_days(day)); };
  EXPECT_EQ(seed(2031y / March / 7d), 20310307'00000u);
  EXPECT_GE(seed(2031y / March / 8d) - seed(2031y / March / 7d), 10'000u) << "no scene is that of the day before";
  StressOptions today = Quick();
  today.count = 1;
  EXPECT_NE(FindingsOf("random", today).said, FindingsOf("random", QuickFrom(1, 1)).said);
}

TEST(Stress, StopsWhenItIsTold) {
  Findings findings;
  findings.most_notes = 3;
  StressRandom(QuickFrom(1, 1000), findings);
  EXPECT_TRUE(findings.rows.empty());
  EXPECT_LE(findings.notes, 5);
}

TEST(RandomScene, IsTheSameForTheSameSeed) {
  std::set<std::string> all;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    all.insert(Describe(MakeRandomScene(seed)));
    EXPECT_EQ(Describe(MakeRandomScene(seed)), Describe(MakeRandomScene(seed)));
  }
  EXPECT_GT(all.size(), 190u);
}

TEST(RandomScene, IsMostlyAcceptedWhereItIsPlausible) {
  std::string everything;
  int plausible = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const RandomScene random = MakeRandomScene(seed);
    if (!random.text.starts_with("title = \"random: ")) continue;
    ++plausible;
    everything += random.text;
    Scene scene;
    ASSERT_NO_THROW(scene = ParseScene(random.text, "random.toml")) << random.text;
    scene.base.seed = seed;
    scene.base.threads = 1;
    EXPECT_NO_THROW(MakeSystem(scene)) << random.text;
  }
  EXPECT_GT(plausible, 200) << "so that most of all are accepted";
  std::vector<std::string> kinds = {
      "a tank", "a channel", "vortices", "a drop", "a star", "a tank of the documents", "\ntangential_velocity = "};
  for (const char* key : {"fluid.arrange", "solver", "walls.kind", "walls.slip"}) {
    for (const std::string& choice : ChoicesOf(key)) kinds.push_back(fmt::format("{} = \"{}\"", key, choice));
  }
  for (const std::string& kind : kinds) EXPECT_NE(everything.find(kind), std::string::npos) << kind;
}

TEST(RandomScene, SetsEveryKeyOfTheSchemaNowAndThen) {
  std::string everything;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) everything += Describe(MakeRandomScene(seed)) + "\n";
  const auto named = [&](const std::string& key) {
    return everything.find(key + " = ") != std::string::npos || everything.find(key + "=") != std::string::npos;
  };
  for (const char* key :
       {"solver", "method.step", "method.integration", "method.kernel", "walls.kind", "forces.central", "periodic.box",
        "fluid.region.disk.radius", "equation_of_state.tait.exponent", "drop.velocity"}) {
    EXPECT_TRUE(named(key)) << key;
  }
}

}  // namespace
}  // namespace sph
