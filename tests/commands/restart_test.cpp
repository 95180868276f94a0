// A run that is saved and gone on with is, bit by bit, the run that never stopped.
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/random.hpp"
#include "commands/program.hpp"
#include "io/scratch.hpp"
#include "scenes/catalogue.hpp"

namespace sph {
namespace {

using nlohmann::json;
using Arguments = Program::Arguments;

Arguments Joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

json RunOf(const Arguments& arguments) {
  const Outcome outcome = RunProgram(Joined({"run", "--json"}, arguments));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out);
}

struct Saved {
  const char* name;
  Arguments scene;
  const char* keys = "";
};

class Restart : public testing::TestWithParam<Saved> {};

TEST_P(Restart, IsTheRunThatNeverStopped) {
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "checkpoint", rows = scratch.Path() / "a.csv",
                    other_rows = scratch.Path() / "b.csv";
  const Arguments keys = {"--keys", GetParam().keys};
  const Arguments every = {"--every", "0.02", "--csv"};
  const Arguments whole = Joined(Joined(GetParam().scene, keys), every);
  const json straight = RunOf(Joined(whole, {rows, "--steps", "240", "--threads", "1"}));
  RunOf(Joined(whole, {other_rows, "--steps", "117", "--checkpoint", file, "--threads", "3"}));
  const json in_two =
      RunOf(Joined(Joined(keys, every), {other_rows, "--restart", file, "--steps", "240", "--threads", "2"}));
  for (const char* what : {"state_hash", "time", "kinetic_energy", "internal_energy", "particles", "deepest", "scene",
                           "solver", "dt_last", "density", "retreats"}) {
    EXPECT_EQ(straight[what], in_two[what]) << what;
  }
  EXPECT_TRUE(Contents(rows) == Contents(other_rows)) << "rows of both parts";
}

INSTANTIATE_TEST_SUITE_P(
    Of, Restart,
    testing::Values(Saved{"Paper", {"dam-break"}, "0.2:d,0.4:Left:0.3,0.7:space"},
                    Saved{"PaperInFloat", {"toy-star", "--precision", "float", "--particles", "700"}},
                    Saved{"Mueller", {"mueller"}, "0.05:space,0.1:space"},
                    Saved{"MuellerPublished", {"mueller-published"}},
                    Saved{"DeltaGas", {"breathing-star", "--particles", "600"}},
                    Saved{"DeltaWithMirrors", {"still-water", "--particles", "500"}},
                    Saved{"DeltaWithWallParticles",
                          {"poiseuille", "--particles", "1500", "--set", "walls.kind=particles"}},
                    Saved{"WallThatSwings",
                          {"couette", "--particles", "600", "--set",
                           "wall.floor.tangential_velocity={ mean = 0.5, amplitude = 1, frequency = 40, phase = 1 }"}},
                    Saved{"DeltaInFloat", {"water-column", "--particles", "800", "--precision", "float"}},
                    Saved{"DeltaPeriodic", {"taylor-green", "--particles", "400"}},
                    Saved{"DeltaNoSlip", {"poiseuille", "--particles", "400"}},
                    Saved{"DeltaAdaptive", {"rotating-square", "--particles", "625", "--set", "method.step=adaptive"}},
                    Saved{"AnotherSceneByKey", {"dam-break", "--set", "method.step=adaptive"}, "0.1:d,0.3:],0.002:c"},
                    Saved{"AfterAReset", {"dam-break"}, "0.1:d,0.3:r,0.5:d"},
                    Saved{"AfterARetreat", {"dam-break", "--set", "method.time_step=0.05"}, "1:d"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Restarting, MayGoOnWithOtherKeysOfItsOwn) {
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "checkpoint";
  RunOf({"dam-break", "--steps", "100", "--checkpoint", file});
  const json with = RunOf({"--restart", file, "--keys", "0.1:space,0.5:d", "--steps", "200"});
  const json straight = RunOf({"dam-break", "--keys", "0.5:d", "--steps", "200"});
  EXPECT_EQ(with["particles"], straight["particles"].get<int>() + 150) << "what is due since then is pressed at once";
  EXPECT_EQ(RunOf({"--restart", file, "--keys", "0.5:d", "--steps", "200"})["state_hash"], straight["state_hash"]);
}

TEST(Restarting, RefusesOptionsThatDiffer) {
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "checkpoint";
  RunOf({"dam-break", "--particles", "300", "--steps", "3", "--checkpoint", file});
  EXPECT_TRUE(Refuses(2, {"run", "--restart", file, "--particles", "200"}, {"--particles 300", "not --particles 200"}));
  EXPECT_TRUE(Refuses(2, {"run", "--restart", file, "--seed", "5"}, {"no --seed", "not --seed 5"}));
  EXPECT_TRUE(Refuses(2, {"run", "--restart", file, "--set", "until=5"}, {"--set", "until=5"}));
  EXPECT_TRUE(Refuses(2, {"run", "toy-star", "--restart", file}, {"scene dam-break", "not toy-star"}));
  EXPECT_EQ(RunProgram({"run", "dam-break", "--particles", "300", "--restart", file, "--steps", "4"}).exit_code, 0);
  EXPECT_TRUE(Refuses(1, {"run", "--restart", file + "-"}, {file + "-", "No such file"}));
}

TEST(Restarting, RefusesAnAlteredSceneFile) {
  const ScratchDirectory scratch;
  const std::string scene = scratch.Path() / "my.toml", file = scratch.Path() / "checkpoint";
  std::filesystem::copy_file(FindScene("dam-break"), scene);
  RunOf({scene, "--steps", "3", "--checkpoint", file});
  EXPECT_EQ(RunProgram({"run", "--restart", file, "--steps", "4"}).exit_code, 0);
  std::ofstream(scene, std::ios::app) << "# another\n";
  EXPECT_TRUE(Refuses(1, {"run", "--restart", file}, {"my.toml", "not the one"}));
}

TEST(Checkpointing, OfAnUnstableRunLeavesTheLastGoodOne) {
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "checkpoint";
  const Arguments scene = {"run", "--set", "method.time_step=0.025", "--set", "method.retries=0", "--checkpoint", file};
  EXPECT_EQ(RunProgram(scene).exit_code, 3);
  EXPECT_EQ(RunOf({"--restart", file, "--steps", "0"})["status"], "ok");
}

TEST(Checkpointing, InterruptedSavesTheLastStep) {
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "checkpoint";
  Program program({"run", "--until", "1e6", "--json", "--checkpoint", file, "--keys", "0.5:d"});
  ASSERT_TRUE(program.Says("break the dam"));
  program.Signal(SIGTERM);
  const Outcome outcome = program.Wait();
  EXPECT_EQ(outcome.exit_code, 130);
  const long steps = json::parse(outcome.out)["steps"].get<long>();
  const json again = RunOf({"--restart", file, "--steps", std::to_string(steps)});
  EXPECT_EQ(again["state_hash"], json::parse(outcome.out)["state_hash"]);
}

TEST(Checkpointing, RefusesAtOnceWhereItCannotWrite) {
  EXPECT_TRUE(Refuses(1, {"run", "--steps", "3", "--checkpoint", "/proc/none/file"}, {"/proc/none/file"}));
}

/// How often; 200 where SPHLAB_KILLS says so.
int Kills() {
  const char* wanted = std::getenv("SPHLAB_KILLS");
  return wanted != nullptr ? std::atoi(wanted) : 12;
}

TEST(Checkpointing, KilledAtAnyMomentLeavesWholeFilesAndCanGoOn) {
  Random random(1);
  for (int kill = 0; kill < Kills(); ++kill) {
    const ScratchDirectory scratch;
    const std::string file = scratch.Path() / "checkpoint", rows = scratch.Path() / "rows.csv";
    RunOf({"--particles", "300", "--steps", "1", "--checkpoint", file, "--csv", rows, "--every", "0.004"});
    Program program({"run", "--restart", file, "--until", "1e6", "--checkpoint", file, "--checkpoint-every", "0.0001",
                     "--csv", rows, "--every", "0.004", "--keys", "0.4:d"});
    std::this_thread::sleep_for(std::chrono::duration<double>(random.Uniform(0, 0.2)));
    program.Signal(SIGKILL);
    program.Wait();
    const json state = RunOf({"--restart", file, "--steps", "0"});
    EXPECT_EQ(state["status"], "ok");
    const std::string text = Contents(rows);
    EXPECT_TRUE(text.starts_with("time [s],") && text.ends_with("\n"));
    const std::string more = std::to_string(state["steps"].get<long>() + 5);
    const json on = RunOf({"--restart", file, "--steps", more, "--keys", "0.4:d"});
    const json straight = RunOf({"--particles", "300", "--steps", more, "--keys", "0.4:d"});
    EXPECT_EQ(on["state_hash"], straight["state_hash"]) << "killed at step " << state["steps"];
  }
}

}  // namespace
}  // namespace sph
