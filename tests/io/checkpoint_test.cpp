#include "io/checkpoint.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/scratch.hpp"
#include "io/trouble.hpp"
#include "io/whole_file.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> AState() {
  std::vector<std::byte> state(300);
  for (std::size_t k = 0; k < state.size(); ++k) state[k] = static_cast<std::byte>(7 * k);
  return state;
}

std::vector<std::byte> FileOf(std::span<const std::byte> state) {
  const ScratchDirectory scratch;
  WriteCheckpoint(scratch.Path() / "c", state);
  const std::string text = Contents(scratch.Path() / "c");
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST(Checkpoint, GivesBackTheState) {
  const ScratchDirectory scratch;
  for (const auto& state : {AState(), std::vector<std::byte>()}) {
    WriteCheckpoint(scratch.Path() / "c", state);
    EXPECT_EQ(ReadCheckpoint(scratch.Path() / "c"), state);
  }
}

TEST(Checkpoint, IsRefusedAtEveryLengthButItsOwn) {
  std::vector<std::byte> file = FileOf(AState());
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_THROW(DecodeCheckpoint(std::span(file).first(length), "c"), TroubleError) << length;
  }
  file.push_back(std::byte{});
  EXPECT_THROW(DecodeCheckpoint(file, "c"), TroubleError) << "one byte more";
}

TEST(Checkpoint, IsRefusedWithAnyBitOfAnyByteTurnedOver) {
  const std::vector<std::byte> file = FileOf(AState());
  for (std::size_t k = 0; k < file.size(); ++k) {
    for (int bit = 0; bit < 8; ++bit) {
      std::vector<std::byte> altered = file;
      altered[k] ^= std::byte{1} << bit;
      EXPECT_THROW(DecodeCheckpoint(altered, "c"), TroubleError) << "byte " << k << ", bit " << bit;
    }
  }
}

TEST(Checkpoint, SaysWhatIsWrong) {
  const ScratchDirectory scratch;
  const fs::path path = scratch.Path() / "c";
  EXPECT_TRUE(Complains([&] { ReadCheckpoint(path); }, {path.c_str(), "No such file"}));
  EXPECT_TRUE(Complains([&] { ReadCheckpoint(scratch.Path()); }, {scratch.Path().c_str(), "directory"}));
  WriteWholeFile(path, "a text");
  EXPECT_TRUE(Complains([&] { ReadCheckpoint(path); }, {path.c_str(), "no checkpoint"}));
  std::vector<std::byte> file = FileOf(AState());
  file[8] = std::byte{99};
  EXPECT_TRUE(Complains([&] { DecodeCheckpoint(file, "c"); }, {"c", "version 99", "reads version 2"}));
}

}  // namespace
}  // namespace sph
