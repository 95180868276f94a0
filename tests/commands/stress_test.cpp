// `sphlab stress`: its table, its JSON, its files, its exit codes, and what it refuses.
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

TEST(Stress, IsDoneWhenEveryRowHolds) {
  const Outcome outcome = RunProgram({"stress", "random", "--quick", "--seed", "64", "--count", "1", "--threads", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  for (const char* part : {"test ", "random", "1 scenes, seeds from 64 on", "refused", "holds"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(outcome.out.find(" open "), std::string::npos);
}

TEST(Stress, SlowGivesTheFieldsOfItsReportAndItsFiles) {
  const ScratchDirectory scratch;
  const auto out = scratch.Path() / "new" / "folder";
  const Outcome outcome =
      RunProgram({"stress", "starts", "size", "--quick", "--count", "2", "--json", "--out", out.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  std::set<std::string> tests;
  for (const auto& row : nlohmann::json::parse(outcome.out)) {
    std::vector<std::string> fields;
    for (const auto& [field, value] : row.items()) fields.push_back(field);
    EXPECT_EQ(fields,
              (std::vector<std::string>{"bar", "holds", "metric", "note", "test", "value", "wall_seconds", "what"}));
    EXPECT_TRUE(row["holds"].get<bool>()) << row;
    tests.insert(row["test"].get<std::string>());
  }
  EXPECT_EQ(tests, (std::set<std::string>{"starts", "size"}));
  for (const char* name : {"starts-toy-star", "starts-dam-break", "size"}) {
    EXPECT_TRUE(Contents(out / (std::string(name) + ".png")).starts_with("\x89PNG")) << name;
    const std::string csv = Contents(out / (std::string(name) + ".csv"));
    EXPECT_GE(std::count(csv.begin(), csv.end(), '\n'), 3) << name;
  }
}

TEST(Stress, RepeatsOneSceneAndSaysWhatItIs) {
  const Outcome outcome = RunProgram({"stress", "random", "--quick", "--seed", "7", "--count", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_NE(outcome.err.find("title = \"random"), std::string::npos) << outcome.err;
}

TEST(Stress, SaysTheSeedOfTheDay) {
  const Outcome outcome = RunProgram({"stress", "random", "--quick", "--count", "1", "--threads", "1"});
  EXPECT_NE(outcome.out.find("seeds from 20"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("00000 on"), std::string::npos) << outcome.out;
}

TEST(Stress, EndsWhenItIsInterrupted) {
  Program program({"stress", "random", "--count", "10000000", "--threads", "1"});
  std::this_thread::sleep_for(std::chrono::seconds(1));
  program.Signal(SIGINT);
  EXPECT_EQ(program.Wait().exit_code, 130);
}

TEST(Stress, RefusesWhatIsNotThere) {
  EXPECT_TRUE(Refuses(2, {"stress", "step-limits"}, {"'step-limits'", "Did you mean 'step-limit'?", "random"}));
  EXPECT_TRUE(Refuses(2, {"stress", "--count", "0"}, {"--count"}));
  EXPECT_TRUE(Refuses(2, {"stress", "--threads", "-1"}, {"--threads"}));
  EXPECT_TRUE(Refuses(1, {"stress", "random", "--count", "1", "--out", "/dev/null/folder"}, {"/dev/null/folder"}));
}

}  // namespace
}  // namespace sph
