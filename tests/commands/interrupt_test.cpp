// Interrupted, the program ends with 130 and leaves whole files.
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands/program.hpp"
#include "io/png.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

TEST(Interrupt, EndsARunWithItsReportAndItsRows) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ScratchDirectory scratch;
    const std::filesystem::path file = scratch.Path() / "run.csv";
    Program program({"run", "--until", "1e6", "--json", "--csv", file, "--keys", "0.1:d"});
    ASSERT_TRUE(program.Says("break the dam"));
    program.Signal(signal);
    const Outcome outcome = program.Wait();
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["status"], "ok");
    EXPECT_GE(report["time"].get<double>(), 0.1);
    const std::string rows = Contents(file);
    EXPECT_TRUE(rows.ends_with("\n"));
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2 + report["steps"].get<long>()) << "every step has its row";
    EXPECT_EQ(scratch.Count(), 1) << "no temporary file is left";
  }
}

TEST(Interrupt, EndsARenderAfterAWholePicture) {
  const ScratchDirectory scratch;
  Program program({"render", "--out", scratch.Path(), "--until", "1000", "--fps", "250", "--keys", "0.02:d"});
  ASSERT_TRUE(program.Says("break the dam"));  // between the fifth picture and the sixth
  program.Signal(SIGINT);
  const Outcome outcome = program.Wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_GE(scratch.Count(), 5);
  for (const auto& entry : std::filesystem::directory_iterator(scratch.Path())) {
    EXPECT_EQ(entry.path().extension(), ".png");
    EXPECT_EQ(ReadPng(entry.path()).width, 960);
  }
}

}  // namespace
}  // namespace sph
