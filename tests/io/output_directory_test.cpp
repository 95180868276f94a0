#include "io/output_directory.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "io/scratch.hpp"
#include "io/trouble.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

TEST(OutputDirectory, IsMadeWithItsParentsAndKeptIfItIsThere) {
  const ScratchDirectory scratch;
  const fs::path path = scratch.Path() / "a" / "b";
  PrepareOutputDirectory(path);
  std::ofstream(path / "file") << "text";
  PrepareOutputDirectory(path);
  EXPECT_TRUE(fs::exists(path / "file"));
}

TEST(OutputDirectory, IsRefusedWhereAFileIs) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.Path() / "file") << "text";
  EXPECT_TRUE(Complains([&] { PrepareOutputDirectory(scratch.Path() / "file"); }, {"file", "not a directory"}));
  EXPECT_THROW(PrepareOutputDirectory(scratch.Path() / "file" / "below"), TroubleError);
}

TEST(OutputDirectory, IsRefusedWhereNothingCanBeWritten) {
  EXPECT_TRUE(Complains([] { PrepareOutputDirectory("/proc/sphlab"); }, {"cannot be created"}));
  const ScratchDirectory scratch;
  const fs::path& path = scratch.Path();
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_exec);
  {
    const OrdinaryUser user;
    EXPECT_TRUE(Complains([&] { PrepareOutputDirectory(path); }, {path.c_str(), "Permission denied"}));
  }
  fs::permissions(path, fs::perms::owner_all);
}

}  // namespace
}  // namespace sph
