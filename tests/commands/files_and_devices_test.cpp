// What the machine refuses: files, full disks, GL libraries, displays. Exit code 1, a message, nothing spoilt.
#include <filesystem>

#include "commands/pictures.hpp"
#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

TEST(SceneFile, ThatCannotBeReadIsNamedWithTheReason) {
  const ScratchDirectory scratch;
  const std::string missing = scratch.Path() / "missing.toml";
  EXPECT_TRUE(Refuses(1, {"run", missing}, {missing, "No such file"}));
  const std::string folder = scratch.Path() / "folder.toml";
  fs::create_directory(folder);
  EXPECT_TRUE(Refuses(1, {"run", folder}, {folder, "it is a directory"}));
  const std::string broken = scratch.Path() / "broken.toml";
  fs::create_symlink("/proc/self/mem", broken);  // opens, but cannot be read; for the superuser, too
  EXPECT_TRUE(Refuses(1, {"info", broken}, {broken, "cannot read"}));
}

TEST(SceneFolder, ThatIsMissingIsNamedWithTheVariableThatSetsIt) {
  const Surroundings elsewhere{{{"SPHLAB_ASSETS", "/nowhere/at/all"}}};
  EXPECT_TRUE(Refuses(1, {"scenes"}, {"/nowhere/at/all/scenes", "SPHLAB_ASSETS"}, elsewhere));
}

TEST(OutputFolder, ThatCannotBeMadeOrWrittenIsRefusedBeforeTheRun) {
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "file";
  std::ofstream(file) << "mine";
  for (const std::string& folder : {file, file + "/below", std::string("/proc/sphlab")}) {
    // A run to the end of time: the refusal cannot come after it.
    EXPECT_TRUE(Refuses(1, {"render", "--out", folder, "--until", "1e6"}, {folder}));
    EXPECT_TRUE(Refuses(1, {"run", "--csv", folder + "/run.csv", "--until", "1e9"}, {folder}));
  }
  EXPECT_TRUE(Refuses(1, {"run", "--csv", scratch.Path(), "--until", "1e9"}, {scratch.Path(), "is a directory"}));
  EXPECT_TRUE(Refuses(1, {"figures", "--out", file}, {file, "not a directory"}));
  EXPECT_EQ(Contents(file), "mine");
  EXPECT_EQ(scratch.Count(), 1);
}

constexpr int kRoom = 1200;  // bytes: for the file of 1024 that an OpenMP library may make, not for what is written

TEST(FullDisk, EndsARenderWithAMessageAndLeavesWhatWasThere) {
  const ScratchDirectory scratch;
  const fs::path old_frame = scratch.Path() / "frame_000000.png";
  std::ofstream(old_frame) << "an older picture";
  const FullDisk full(kRoom);
  EXPECT_TRUE(Refuses(1, {"render", "--out", scratch.Path(), "--frames", "2", "--threads", "1"},
                      {old_frame, "cannot write", "File too large"}, {{{"MESA_SHADER_CACHE_DISABLE", "true"}}}));
  EXPECT_EQ(Contents(old_frame), "an older picture");
  EXPECT_EQ(scratch.Count(), 1);
}

TEST(FullDisk, EndsARunWithAMessageAndLeavesWhatWasThere) {
  const ScratchDirectory scratch;
  const fs::path old_file = scratch.Path() / "run.csv";
  std::ofstream(old_file) << "older rows";
  const FullDisk full(kRoom);
  EXPECT_TRUE(Refuses(1, {"run", "--csv", old_file, "--steps", "50", "--threads", "1"}, {old_file, "File too large"}));
  EXPECT_EQ(Contents(old_file), "older rows");
  EXPECT_EQ(scratch.Count(), 1);
}

TEST(FullDevice, IsNoSuccess) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_TRUE(Refuses(1, {"run", "--csv", "/dev/full", "--steps", "2"}, {"/dev/full", "No space left on device"}));
  const Surroundings full{{}, "/dev/full"};
  EXPECT_TRUE(Refuses(1, {"run", "--steps", "2", "--json"}, {"standard output", "No space left on device"}, full));
  EXPECT_TRUE(Refuses(1, {"scenes"}, {"standard output", "No space left on device"}, full));
  EXPECT_TRUE(Refuses(1, {"run", "--help"}, {"standard output"}, full));
}

/// A folder in which files of these names are found first, and are no libraries.
class BrokenLibraries {
 public:
  explicit BrokenLibraries(std::initializer_list<const char*> names) {
    for (const char* name : names) std::ofstream(scratch_.Path() / name) << std::string(1000, 'x');
  }
  Surroundings Used() const { return {{{"LD_LIBRARY_PATH", scratch_.Path().string()}}}; }

 private:
  ScratchDirectory scratch_;
};

TEST(NoGl, IsSaidWithLibrariesAndPackagesAndNothingIsMade) {
  const BrokenLibraries broken({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1", "libEGL.so"});
  const ScratchDirectory scratch;
  const std::string out = scratch.Path() / "frames";
  const std::vector<std::string> says = {"libOSMesa.so.8", "libosmesa6", "libEGL.so.1", "libegl1",
                                         "invalid ELF header"};
  EXPECT_TRUE(Refuses(1, {"render", "--out", out}, says, broken.Used()));
  EXPECT_TRUE(Refuses(1, {"render", "--out", out, "--backend", "osmesa"}, {"libosmesa6"}, broken.Used()));
  EXPECT_TRUE(Refuses(1, {"render", "--out", out, "--backend", "egl"}, {"libegl1"}, broken.Used()));
  EXPECT_EQ(scratch.Count(), 0);
  const Outcome info = RunProgram({"info"}, broken.Used());
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_NE(info.out.find("GL back-end osmesa: not available"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("GL back-end egl: not available"), std::string::npos) << info.out;
  EXPECT_EQ(RunProgram({"run", "--steps", "1"}, broken.Used()).exit_code, 0) << "run needs no GL";
}

TEST(NoOsmesa, LeavesEgl) {
  const BrokenLibraries broken({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
  const ScratchDirectory scratch;
  const Outcome outcome = RunProgram({"render", "--out", scratch.Path(), "--frames", "1", "--json"}, broken.Used());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"backend\": \"egl\""), std::string::npos) << outcome.out;
}

TEST(NoDisplay, IsSaidWithWhatToDoWithoutOne) {
  EXPECT_TRUE(Refuses(1, {"toy-star"}, {"DISPLAY is not set", "`sphlab render toy-star --out frames`"},
                      {{{"DISPLAY", std::nullopt}}}));
  EXPECT_TRUE(Refuses(1, {}, {":4711", "sphlab render"}, {{{"DISPLAY", ":4711"}}}));
}

}  // namespace
}  // namespace sph
