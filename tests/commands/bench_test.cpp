// `sphlab bench speed`: its files, and that they say what was printed. How fast the machine is does not matter.
#include <algorithm>

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
  for (const char* part : {"compiled by ", " with -O", "limit: ", "collapse ", "baseline", "double"}) {
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part;
  }
  for (const char* file : {"speed.csv", "skips.csv"}) {
    const std::string csv = Contents(out / file);
    EXPECT_GT(std::count(csv.begin(), csv.end(), '\n'), 5) << file;
  }
}

TEST(Bench, RefusesCasesAndFoldersThatAreNone) {
  EXPECT_TRUE(Refuses(2, {"bench", "slowness", "--out", "folder"}, {"slowness", "speed"}));
  EXPECT_TRUE(Refuses(2, {"bench", "speed"}, {"--out"}));
  EXPECT_TRUE(Refuses(1, {"bench", "speed", "--out", "/dev/null/folder"}, {"/dev/null/folder"}));
}

}  // namespace
}  // namespace sph
