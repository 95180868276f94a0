// Others' results: read from their files, judged as ours, and compared along our frontier.
#include "lab/rivals.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>

#include "base/error.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

const VerificationCase& Case(const std::string& name) {
  return *std::ranges::find(AllVerificationCases(), name, &VerificationCase::name);
}

/// As long as it lives, the Python that PySPH is looked for in is this shell script.
class Python {
 public:
  Python(const std::filesystem::path& file, const std::string& script) {
    std::ofstream(file) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("SPHLAB_PYTHON", file.c_str(), 1);
  }
  ~Python() { unsetenv("SPHLAB_PYTHON"); }
  Python(const Python&) = delete;
  Python& operator=(const Python&) = delete;
};

constexpr const char* kPeerFile =
    "# seconds 12.5\n# particles 2\n# version 1.0\n# example an_example\n# scheme A scheme\n"
    "t [s],x [m],y [m],vx [m/s],vy [m/s],mass [kg/m],pressure [Pa]\n"
    "0.0,1.0,0.0,-100.0,0.0,0.5,3e5\n0.0,0.0,1.0,0.0,100.0,0.5,2\n"
    "0.0076,0.5,0.0,-90.0,0.0,0.5,1\n0.0076,0.0,1.944517,0.0,100.0,0.5,0\n";

TEST(PeerFile, HasFactsAndSnapshots) {
  const ScratchDirectory scratch;
  const auto file = scratch.Path() / "peer.csv";
  std::ofstream(file) << kPeerFile;
  const PeerFile peer = ReadPeerFile(file);
  EXPECT_EQ(peer.Fact("seconds"), "12.5");
  EXPECT_EQ(peer.Fact("scheme"), "A scheme");
  EXPECT_THROW(peer.Fact("colour"), TroubleError);
  ASSERT_EQ(peer.snapshots.size(), 2u);
  EXPECT_EQ(peer.snapshots[1].time, 0.0076);
  EXPECT_EQ(peer.snapshots[1].particles.y[1], 1.944517);
  EXPECT_EQ(peer.snapshots[0].pressure[0], 3e5);
}

TEST(PeerFile, IsRefusedWithTheRowThatIsWrong) {
  const ScratchDirectory scratch;
  const auto file = scratch.Path() / "peer.csv";
  for (const char* row : {"0,1,2,3,4,5", "0,1,2,3,4,5,6,7", "0,1,2,3,4,5,six", ""}) {
    std::ofstream(file) << "t,x,y,vx,vy,mass,pressure\n" << row << (*row == '\0' ? "" : "\n");
    EXPECT_THROW(ReadPeerFile(file), TroubleError) << row;
  }
}

TEST(PySph, IsRunForTheCasesTimesAndJudgedAsOurRunsAre) {
  const ScratchDirectory scratch;
  // Notes its arguments, and answers with the file above.
  const Python python(scratch.Path() / "python", std::string("echo \"$@\" >> '") + (scratch.Path() / "calls").string() +
                                                     "'\n[ \"$1\" = -c ] || cat > \"$4\" <<'END'\n" + kPeerFile +
                                                     "END\n");
  RequirePySph();
  const RivalRun run = RunPySph(Case("elliptic-drop"), 20, scratch.Path());
  const std::string calls = Contents(scratch.Path() / "calls");
  EXPECT_NE(calls.find("elliptic-drop 20 "), std::string::npos);
  EXPECT_NE(calls.find(" 0 0.0076\n"), std::string::npos) << calls;
  EXPECT_EQ(run.who, "PySPH 1.0, A scheme");
  EXPECT_EQ(run.particles, 2u);
  EXPECT_EQ(run.seconds, 12.5);
  ASSERT_EQ(run.errors.size(), 3u);
  EXPECT_LT(run.errors[1], 5e-7) << "the axis is exact";
  EXPECT_NEAR(run.errors[2], 1 - (8100 + 1e4) / 2e4, 1e-12) << "kinetic energy";
  EXPECT_EQ(run.errors[0], run.errors[2]) << "the greatest";
}

TEST(PySph, IsNamedAsMissingWithItsPackage) {
  setenv("SPHLAB_PYTHON", "/bin/false", 1);
  try {
    RequirePySph();
    ADD_FAILURE() << "nothing was missing";
  } catch (const TroubleError& error) {
    EXPECT_NE(std::string(error.what()).find("python3-pysph"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("/bin/false"), std::string::npos);
  }
  unsetenv("SPHLAB_PYTHON");
}

TEST(PySph, ThatFailsIsReportedWithWhereItsWordsAre) {
  const ScratchDirectory scratch;
  const Python python(scratch.Path() / "python", "echo trouble >&2; exit 3\n");
  EXPECT_THROW(RunPySph(Case("poiseuille"), 0, scratch.Path()), TroubleError);
  EXPECT_EQ(Contents(scratch.Path() / "pysph-poiseuille.log"), "trouble\n");
}

TEST(PySph, ThatEndsTooEarlyIsReported) {
  const ScratchDirectory scratch;
  const Python python(scratch.Path() / "python", std::string("cat > \"$4\" <<'END'\n") + kPeerFile + "END\n");
  EXPECT_THROW(RunPySph(Case("taylor-green"), 25, scratch.Path()), TroubleError);
}

TEST(PySph, HasExamplesOfCasesThatCanBeJudged) {
  int examples = 0;
  for (const VerificationCase& of : AllVerificationCases()) {
    if (PySphResolutions(of.name).empty()) continue;
    ++examples;
    EXPECT_NE(of.judgement, nullptr) << of.name;
  }
  EXPECT_EQ(examples, 5);
}

PricedRun RunOf(const std::string& solver, double seconds, double error) {
  PricedRun run;
  run.method.solver = solver;
  run.particles = 400;
  run.repetitions = 1;
  run.least = seconds;
  run.errors = {error};
  return run;
}

/// Solver delta takes 1/error seconds.
PricedCase Example(const std::string& name) {
  PricedCase of;
  of.name = name;
  of.what = "an example";
  of.own_particles = 400;
  of.metrics = {"an error"};
  of.runs = {RunOf("delta", 10, 0.1), RunOf("delta", 100, 0.01), RunOf("paper", 0.1, 0.02)};
  return of;
}

TEST(Rivalry, IsOurTimeToTheSameErrorOverTheirs) {
  const auto rows = Compare(Example("case"), {"case", "another", 10, 200, {0.05}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].ours.seconds, 20, 1e-9) << "delta's alone, the paper's solver is faster";
  EXPECT_NEAR(rows[0].Ratio(), 0.1, 1e-9);
  EXPECT_NE(RivalTableRow(rows[0]).find(" 0.1 "), std::string::npos);
  const auto never = Compare(Example("case"), {"case", "a better one", 10, 200, {0.005}});
  EXPECT_NE(RivalTableRow(never[0]).find("not reached"), std::string::npos);
  EXPECT_NE(RivalriesAsCsv(never).find("never,,"), std::string::npos);
}

TEST(PaperRivals, AreWhatItsSolverReachedAndWhatThePaperReports) {
  EXPECT_TRUE(PaperRivals(Case("graded-star"), Example("graded-star"), {}).empty());
  EXPECT_TRUE(PaperRivals(Case("toy-star"), Example("toy-star"), {.quick = true}).empty());
  const auto rivals = PaperRivals(Case("toy-star"), Example("toy-star"), {});
  ASSERT_EQ(rivals.size(), 2u);
  EXPECT_EQ(rivals[0].errors, (std::vector{0.02}));
  EXPECT_EQ(rivals[1].seconds, rivals[0].seconds);
  // 0.04 kg^2/m^6; the centre has 2 M/(pi R^2) = 2.2635 kg/m^3.
  EXPECT_NEAR(rivals[1].errors[0], 0.2 / 2.2635, 1e-5);
}

TEST(PaperRivals, AreRunIfTheyWereLeftOut) {
  PricedCase priced = Example("toy-star");
  priced.own_particles = 64;
  priced.runs.clear();
  const auto rivals = PaperRivals(Case("toy-star"), priced, {});
  ASSERT_EQ(rivals.size(), 2u);
  EXPECT_EQ(rivals[0].particles, 64u);
  EXPECT_GT(rivals[0].seconds, 0);
  EXPECT_GT(rivals[0].errors.at(0), 0.001);
  EXPECT_LT(rivals[0].errors.at(0), 0.1);
}

}  // namespace
}  // namespace sph
