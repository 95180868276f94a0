// What goes wrong under the program while it runs: a disk that fills up, one that is read-only, memory that runs out, a
// display that dies. Each time a message and exit code 1; what is on disk is whole.
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <thread>

#include "commands/program.hpp"
#include "io/png.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

/// A disk of its own in memory, where the user may mount one.
class SmallDisk {
 public:
  explicit SmallDisk(const std::string& size)
      : works_(mount("sphlab-test", scratch_.Path().c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0) {}
  ~SmallDisk() {
    if (works_) umount2(scratch_.Path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool Works() const { return works_; }
  void MakeReadOnly() const {
    EXPECT_EQ(mount("sphlab-test", scratch_.Path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr), 0);
  }
  const fs::path& Path() const { return scratch_.Path(); }
  long Count() const { return std::distance(fs::directory_iterator(Path()), fs::directory_iterator()); }

 private:
  ScratchDirectory scratch_;
  bool works_;
};

constexpr const char* kNoMount = "only root may mount a small disk";

TEST(SmallDisk, ThatACheckpointDoesNotFitOnKeepsTheLastOne) {
  const SmallDisk disk("64k");
  if (!disk.Works()) GTEST_SKIP() << kNoMount;
  const std::string file = disk.Path() / "checkpoint";
  ASSERT_EQ(RunProgram({"run", "--particles", "50", "--steps", "5", "--quiet", "--checkpoint", file}).exit_code, 0);
  const std::string before = Contents(file);
  EXPECT_TRUE(Refuses(1, {"run", "--particles", "5000", "--steps", "5", "--checkpoint", file},
                      {file, "No space left on device"}));
  EXPECT_EQ(Contents(file), before);
  EXPECT_EQ(disk.Count(), 1) << "nothing half-written";
  EXPECT_EQ(RunProgram({"run", "--restart", file, "--steps", "9", "--quiet"}).exit_code, 0);
}

TEST(SmallDisk, ThatFillsUpWithPicturesKeepsWholeOnes) {
  const SmallDisk disk("100k");
  if (!disk.Works()) GTEST_SKIP() << kNoMount;
  EXPECT_TRUE(Refuses(1, {"render", "--out", disk.Path(), "--frames", "200", "--size", "640x480", "--quiet"},
                      {"cannot write", "No space left on device"}));
  EXPECT_GE(disk.Count(), 2);
  for (const auto& entry : fs::directory_iterator(disk.Path())) {
    EXPECT_EQ(ReadPng(entry.path()).width, 640) << entry.path();
  }
}

TEST(SmallDisk, ThatIsReadOnlyIsRefusedBeforeTheRun) {
  const SmallDisk disk("100k");
  if (!disk.Works()) GTEST_SKIP() << kNoMount;
  disk.MakeReadOnly();
  const std::string folder = disk.Path() / "frames", file = disk.Path() / "file";
  EXPECT_TRUE(Refuses(1, {"render", "--out", folder, "--until", "1e6"}, {folder, "Read-only file system"}));
  EXPECT_TRUE(Refuses(1, {"run", "--checkpoint", file, "--until", "1e6"}, {file, "Read-only file system"}));
  EXPECT_TRUE(Refuses(1, {"run", "--csv", file, "--steps", "2"}, {disk.Path(), "Read-only file system"}));
  EXPECT_TRUE(Refuses(1, {"stress", "random", "--count", "1", "--out", folder}, {folder, "Read-only file system"}));
}

/// As long as it lives, programs that are started get no more memory than that, as with `ulimit -v`.
class LittleMemory {
 public:
  explicit LittleMemory(rlim_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  ~LittleMemory() { setrlimit(RLIMIT_AS, &before_); }
  LittleMemory(const LittleMemory&) = delete;
  LittleMemory& operator=(const LittleMemory&) = delete;

 private:
  rlimit before_ = {};
};

TEST(Memory, SlowThatRunsOutIsSaid) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer takes all addresses";
#endif
  const ScratchDirectory scratch;
  const LittleMemory little(rlim_t{600} << 20);
  EXPECT_TRUE(Refuses(1, {"run", "--particles", "8000000", "--steps", "2", "--threads", "1"}, {"out of memory"}));
  EXPECT_TRUE(Refuses(1,
                      {"render", "--particles", "8000000", "--frames", "1", "--threads", "1", "--out", scratch.Path()},
                      {"out of memory"}));
  EXPECT_EQ(scratch.Count(), 0);
  EXPECT_EQ(RunProgram({"run", "--steps", "2", "--threads", "1", "--quiet"}).exit_code, 0) << "which fits";
}

/// An X server without a screen, to be killed.
class DoomedDisplay {
 public:
  DoomedDisplay()
      : pipe_(popen("echo $$; exec Xvfb -displayfd 1 -screen 0 1280x1024x24 -nolisten tcp 2>/dev/null", "r")) {
    if (pipe_ == nullptr || std::fscanf(pipe_, "%d %d", &server_, &number_) != 2) server_ = -1;
  }
  ~DoomedDisplay() {
    Kill();
    if (pipe_ != nullptr) pclose(pipe_);
  }
  DoomedDisplay(const DoomedDisplay&) = delete;
  DoomedDisplay& operator=(const DoomedDisplay&) = delete;

  bool Works() const { return server_ > 0; }
  std::string Name() const { return ":" + std::to_string(number_); }
  void Kill() {
    if (server_ > 0) kill(server_, SIGKILL);
    server_ = -1;
  }

 private:
  std::FILE* pipe_;
  int server_ = -1, number_ = -1;
};

TEST(Display, SlowThatDiesUnderTheWindowEndsTheProgramWithAMessage) {
  for (const double seconds : {0.1, 1.0, 4.0}) {  // while it opens, and after
    DoomedDisplay display;
    ASSERT_TRUE(display.Works());
    Program program({"dam-break"}, {{{"DISPLAY", display.Name()}}});
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    display.Kill();
    const Outcome outcome = program.Wait();  // ctest ends what hangs
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_NE(outcome.err.find(display.Name()), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace sph
