// `sphlab bench`: its files, and that they say what was printed. How fast the machine is does not matter.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

TEST(Bench, SlowWritesItsTablesAndItsPlot) {
  const ScratchDirectory scratch;
  const auto out = scratch.Path() / "new" / "folder";
  const Outcome outcome = RunProgram({"bench", "speed", "--quick", "--out", out.string()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, Contents(out / "speed.txt") + "\n" + Contents(out / "skips.txt"));
  EXPECT_TRUE(Contents(out / "speed.png").starts_with("\x89PNG"));
  for (const char* part : {"compiled by ", " with -", " -O", "limit: ", "collapse ", "baseline", "double"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  for (const char* file : {"speed.csv", "skips.csv"}) {
    const std::string csv = Contents(out / file);
    EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 5) << file;
  }
}

/// A shell script in place of the Python that has PySPH: a drop of two particles whose axis is exact.
Surroundings WithPeer(const std::filesystem::path& python) {
  std::ofstream(python) << "#!/bin/sh\n[ \"$1\" = -c ] || cat > \"$4\" <<'END'\n"
                           "# seconds 1000\n# particles 2\n# version 7\n# example drop\n# scheme Some scheme\n"
                           "t,x,y,vx,vy,mass,pressure\n"
                           "0,1,0,-100,0,1,0\n0,0,1,0,100,1,0\n"
                           "0.0076,0.5,0,-50,0,1,0\n0.0076,0,1.944517,0,100,1,0\nEND\n";
  std::filesystem::permissions(python, std::filesystem::perms::owner_all);
  return {.environment = {{"SPHLAB_PYTHON", python.string()}}};
}

TEST(Bench, SlowWritesRunTimeAgainstErrorOfACaseAndOfAPeer) {
  const ScratchDirectory scratch;
  const auto out = scratch.Path() / "out";
  const Outcome outcome = RunProgram({"bench", "elliptic-drop", "--quick", "--peers", "--out", out.string()},
                                     WithPeer(scratch.Path() / "python"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, Contents(out / "accuracy.txt"));
  for (const char* part : {"processor time", "paper ", "mueller ", "delta ", "long axis", "Where float ends",
                           "PySPH 7, Some scheme", "as good as others"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(outcome.out.find("taylor-green"), std::string::npos) << "it was not asked for";
  const std::string runs = Contents(out / "elliptic-drop.csv");
  for (const char* part : {"least [s]", "\"long axis at t = 0.0076 s, relative error\"", "delta,float,adaptive,78,"}) {
    EXPECT_NE(runs.find(part), std::string::npos) << part;
  }
  // Kinetic energy 10^4 became (2500 + 10^4)/2: wrong by 0.375, and any run of ours is better within less than 1000 s.
  const std::string rivals = Contents(out / "rivals.csv");
  EXPECT_NE(rivals.find("elliptic-drop,\"PySPH 7, Some scheme\",2,greatest error,0.375,1000,within,0.0"),
            std::string::npos)
      << rivals;
  EXPECT_TRUE(Contents(out / "elliptic-drop.png").starts_with("\x89PNG"));
  EXPECT_TRUE(Contents(out / "accuracy.csv").starts_with("case,metric,solver,"));
  EXPECT_TRUE(Contents(out / "precision.csv").starts_with("case,metric,solver,"));
}

TEST(Bench, SaysWhichPackagePeersNeedBeforeAnythingIsMeasured) {
  const ScratchDirectory scratch;
  const auto out = scratch.Path() / "out";
  EXPECT_TRUE(Refuses(1, {"bench", "elliptic-drop", "--peers", "--out", out.string()}, {"python3-pysph", "/bin/false"},
                      {.environment = {{"SPHLAB_PYTHON", "/bin/false"}}}));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Bench, EndsBetweenRunsWhenInterrupted) {
  const ScratchDirectory scratch;
  const auto out = scratch.Path() / "out";
  Program program({"bench", "water-column", "--quick", "--out", out.string()});
  while (!std::filesystem::exists(out)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.Signal(SIGINT);
  EXPECT_EQ(program.Wait().exit_code, 130);
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

TEST(Bench, RefusesCasesAndFoldersThatAreNone) {
  EXPECT_TRUE(Refuses(2, {"bench", "slowness", "--out", "folder"}, {"slowness", "speed"}));
  EXPECT_TRUE(Refuses(2, {"bench", "speed", "eliptic-drop", "--out", "folder"},
                      {"'eliptic-drop'", "Did you mean 'elliptic-drop'?", "taylor-green"}));
  EXPECT_TRUE(Refuses(2, {"bench", "speed"}, {"--out"}));
  EXPECT_TRUE(Refuses(2, {"bench", "--longest", "0", "--out", "folder"}, {"--longest"}));
  EXPECT_TRUE(Refuses(2, {"bench", "--threads", "0", "--out", "folder"}, {"--threads"}));
  EXPECT_TRUE(Refuses(1, {"bench", "speed", "--out", "/dev/null/folder"}, {"/dev/null/folder"}));
  EXPECT_TRUE(Refuses(1, {"bench", "elliptic-drop", "--out", "/dev/null/folder"}, {"/dev/null/folder"}));
}

}  // namespace
}  // namespace sph
