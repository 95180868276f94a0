// `sphlab verify`: its table, its JSON, its exit codes, and what it refuses.
#include <chrono>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "commands/program.hpp"

namespace sph {
namespace {

TEST(Verify, IsATableThatFitsIntoATerminal) {
  const Outcome outcome = RunProgram({"verify", "operators", "momentum", "--threads", "1"});
  EXPECT_EQ(outcome.err, "");
  for (const char* part : {"operators: ", "delta", "10000", "ratio", "bounded", "invariant", "holds", "bar", "order"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(outcome.exit_code, outcome.out.find(" open\n") == std::string::npos ? 0 : 1) << outcome.out;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
}

TEST(Verify, SlowGivesTheFieldsOfItsReportAndAnExitCodeThatFollowsFromThem) {
  const Outcome outcome = RunProgram({"verify", "elliptic-drop", "taylor-green", "momentum", "--json"});
  const auto report = nlohmann::ordered_json::parse(outcome.out);
  ASSERT_EQ(report.size(), 5u);
  bool all_hold = true;
  for (const auto& row : report) {
    std::vector<std::string> fields;
    for (const auto& [field, value] : row.items()) fields.push_back(field);
    EXPECT_EQ(fields, (std::vector<std::string>{"case", "solver", "particles", "metric", "kind", "value", "bar",
                                                "holds", "order", "ladder", "reference", "wall_seconds"}));
    EXPECT_EQ(row["solver"], "delta");
    const bool error = row["kind"] == "error";
    ASSERT_EQ(row["ladder"].size(), error ? 2u : 1u);
    EXPECT_EQ(row["ladder"].back()[0], row["particles"]);
    EXPECT_EQ(row["ladder"].back()[1], row["value"]);
    const double coarse = row["ladder"].front()[1], fine = row["value"];
    EXPECT_EQ(row["order"].is_number(), error && coarse * fine > 0);
    EXPECT_FALSE(row["holds"].get<bool>() && std::abs(fine) > row["bar"].get<double>());
    all_hold = all_hold && row["holds"].get<bool>();
  }
  EXPECT_EQ(outcome.exit_code, all_hold ? 0 : 1);
}

TEST(Verify, SlowEndsAtOnceWhenInterrupted) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program({"verify", "standing-wave", "--all", "--json"});
    std::this_thread::sleep_for(std::chrono::seconds(1));  // until it is at work
    program.Signal(signal);
    const auto asked = std::chrono::steady_clock::now();
    const Outcome outcome = program.Wait();
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(1));
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.out, "");
  }
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
