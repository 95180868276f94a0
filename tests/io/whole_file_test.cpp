#include "io/whole_file.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "base/error.hpp"
#include "io/scratch.hpp"
#include "io/trouble.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

TEST(WholeFile, HasExactlyTheBytesWritten) {
  const ScratchDirectory scratch;
  const std::string text("a\0b\r\n\xff", 6);
  WriteWholeFile(scratch.Path() / "file", text);
  EXPECT_EQ(Contents(scratch.Path() / "file"), text);
  EXPECT_EQ(scratch.Count(), 1);
}

TEST(WholeFile, ReplacesALongerFileAndKeepsItsPermissions) {
  const ScratchDirectory scratch;
  const fs::path path = scratch.Path() / "file";
  WriteWholeFile(path, "a long file");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  WriteWholeFile(path, "short");
  EXPECT_EQ(Contents(path), "short");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WholeFile, OnAFullDiskLeavesTheOldFileAsItWasAndNothingElse) {
  const ScratchDirectory scratch;
  const fs::path path = scratch.Path() / "file";
  WriteWholeFile(path, "the last good one");
  const std::string large(100'000, 'x');
  {
    const FullDisk full(4096);
    EXPECT_TRUE(Complains([&] { WriteWholeFile(path, large); }, {path.c_str(), "writing", "too large"}));
  }
  EXPECT_EQ(Contents(path), "the last good one");
  EXPECT_EQ(scratch.Count(), 1);
}

TEST(WholeFile, OnAFullDiskLeavesNothingOfANewFile) {
  const ScratchDirectory scratch;
  const std::string large(100'000, 'x');
  {
    const FullDisk full(4096);
    EXPECT_THROW(WriteWholeFile(scratch.Path() / "file", large), TroubleError);
  }
  EXPECT_EQ(scratch.Count(), 0);
}

TEST(WholeFile, SaysSoWhenADeviceIsFull) {
  EXPECT_TRUE(Complains([] { WriteWholeFile("/dev/full", "text"); }, {"/dev/full", "No space left"}));
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "the device must not be replaced";
}

TEST(WholeFile, SaysSoWhenItsDirectoryIsMissingOrIsAFile) {
  const ScratchDirectory scratch;
  WriteWholeFile(scratch.Path() / "file", "text");
  EXPECT_TRUE(
      Complains([&] { WriteWholeFile(scratch.Path() / "missing" / "f", "text"); }, {"missing/f", "No such file"}));
  EXPECT_TRUE(Complains([&] { WriteWholeFile(scratch.Path() / "file" / "f", "text"); }, {"Not a directory"}));
  EXPECT_TRUE(Complains([&] { WriteWholeFile(scratch.Path(), "text"); }, {"Is a directory"}));
}

TEST(WholeFile, RespectsPermissions) {
  const ScratchDirectory scratch;  // its permissions let nobody else write
  const fs::path open = scratch.Path() / "open";
  fs::create_directory(open);
  fs::permissions(scratch.Path(), fs::perms::owner_all | fs::perms::others_exec);
  fs::permissions(open, fs::perms::all);
  WriteWholeFile(open / "file", "mine");
  fs::permissions(open / "file", fs::perms::owner_read | fs::perms::others_read);
  if (geteuid() != 0) fs::permissions(scratch.Path(), fs::perms::owner_read | fs::perms::owner_exec);
  {
    const OrdinaryUser user;
    EXPECT_TRUE(Complains([&] { WriteWholeFile(scratch.Path() / "new", "text"); }, {"Permission denied"}));
    EXPECT_TRUE(Complains([&] { WriteWholeFile(open / "file", "text"); }, {"Permission denied"}));
  }
  fs::permissions(scratch.Path(), fs::perms::owner_all);
  EXPECT_EQ(Contents(open / "file"), "mine");
}

TEST(WholeFile, FollowsASymbolicLink) {
  const ScratchDirectory scratch;
  WriteWholeFile(scratch.Path() / "file", "old");
  fs::create_symlink(scratch.Path() / "file", scratch.Path() / "link");
  WriteWholeFile(scratch.Path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(scratch.Path() / "link"));
  EXPECT_EQ(Contents(scratch.Path() / "file"), "new");
}

TEST(WholeFile, IsOneOfTwoFilesWrittenAtOnceAndNeverAMixture) {
  const ScratchDirectory scratch;
  const fs::path path = scratch.Path() / "file";
  const auto write_often = [&path](char letter) {
    for (int i = 0; i < 20; ++i) WriteWholeFile(path, std::string(50'000, letter));
  };
  write_often('c');
  std::thread a(write_often, 'a');
  std::thread b(write_often, 'b');
  for (int i = 0; i < 50; ++i) {
    const std::string contents = Contents(path);
    EXPECT_EQ(contents, std::string(50'000, contents.empty() ? '?' : contents[0]));
  }
  a.join();
  b.join();
  EXPECT_EQ(scratch.Count(), 1);
}

}  // namespace
}  // namespace sph
