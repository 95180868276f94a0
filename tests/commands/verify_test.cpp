// `sphlab verify`: its table, its JSON, its exit codes, and what it refuses.
#include <nlohmann/json.hpp>
#include <set>

#include "commands/program.hpp"

namespace sph {
namespace {

TEST(Verify, SlowIsDoneWhenEveryMetricOfACaseHolds) {
  const Outcome outcome = RunProgram({"verify", "taylor-green", "--threads", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_EQ(outcome.err, "");
  for (const char* part : {"case ", "taylor-green", "delta", "2500", "L1 of speed", "holds"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(outcome.out.find("open"), std::string::npos);
}

TEST(Verify, SlowGivesTheFieldsOfItsReportAndAnExitCodeThatFollowsFromThem) {
  const Outcome outcome = RunProgram({"verify", "elliptic-drop", "taylor-green", "graded-star", "--json"});
  const auto report = nlohmann::json::parse(outcome.out);
  ASSERT_GE(report.size(), 5u);
  bool all_hold = true;
  std::set<std::string> cases;
  for (const auto& row : report) {
    std::vector<std::string> fields;
    for (const auto& [field, value] : row.items()) fields.push_back(field);
    EXPECT_EQ(fields, (std::vector<std::string>{"bar", "case", "holds", "metric", "particles", "reference", "solver",
                                                "value", "wall_seconds"}));
    EXPECT_EQ(row["holds"].get<bool>(), row["value"].get<double>() <= row["bar"].get<double>());
    EXPECT_EQ(row["solver"], "delta");
    EXPECT_GT(row["particles"].get<int>(), 1000);
    all_hold = all_hold && row["holds"].get<bool>();
    cases.insert(row["case"].get<std::string>());
  }
  EXPECT_EQ(cases, (std::set<std::string>{"elliptic-drop", "taylor-green", "graded-star"}));
  EXPECT_EQ(outcome.exit_code, all_hold ? 0 : 1);
}

TEST(Verify, RefusesACaseThatIsNotThereWithTheNearestName) {
  EXPECT_TRUE(
      Refuses(2, {"verify", "taylor-gren"}, {"'taylor-gren'", "Did you mean 'taylor-green'?", "rotating-square"}));
  EXPECT_TRUE(Refuses(2, {"verify", "--threads", "-1"}, {"--threads"}));
}

TEST(Verify, HelpNamesItsOptions) {
  const Outcome outcome = RunProgram({"verify", "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* part : {"CASE", "--all", "--json", "--threads"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace sph
