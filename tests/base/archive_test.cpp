#include "base/archive.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

struct Everything {
  int number = 0;
  double real = 0;
  bool flag = false;
  std::string text;
  std::vector<float> values;
  std::vector<std::string> texts;
  std::optional<std::uint64_t> some, none;

  void Transfer(Archive& archive) { archive(number, real, flag, text, values, texts, some, none); }
  friend bool operator==(const Everything&, const Everything&) = default;
};

const Everything kExample{-3, 0.1, true, std::string("a\0b", 3), {1, 2, 3}, {"", "x"}, 7, std::nullopt};

std::vector<std::byte> BytesOf(Everything what) {
  std::vector<std::byte> bytes;
  Archive archive = Archive::Writer(bytes, Archive::Extent::kPhysics);
  what.Transfer(archive);
  return bytes;
}

TEST(Archive, GivesBackWhatItWasGiven) {
  const auto bytes = BytesOf(kExample);
  Everything back{1, 1, false, "old", {9}, {"old"}, std::nullopt, 5};
  Archive archive = Archive::Reader(bytes, Archive::Extent::kPhysics);
  back.Transfer(archive);
  EXPECT_EQ(back, kExample);
  EXPECT_TRUE(archive.AtEnd());
}

TEST(Archive, RefusesBytesThatEndTooEarlyAtEveryLength) {
  const auto bytes = BytesOf(kExample);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    Everything back;
    Archive archive = Archive::Reader(std::span(bytes).first(length), Archive::Extent::kPhysics);
    EXPECT_THROW(back.Transfer(archive), TroubleError) << length;
  }
}

TEST(Archive, RefusesAVectorLongerThanWhatIsLeftBeforeItTakesMemory) {
  std::vector<std::byte> bytes;
  std::uint64_t length = UINT64_MAX / 2;
  Archive::Writer(bytes, Archive::Extent::kPhysics)(length);
  std::vector<double> values;
  Archive archive = Archive::Reader(bytes, Archive::Extent::kPhysics);
  EXPECT_THROW(archive(values), TroubleError);
}

TEST(Archive, RefusesAFlagThatIsNeitherTrueNorFalse) {
  std::vector<std::byte> bytes = {std::byte{2}};
  bool flag = false;
  Archive archive = Archive::Reader(bytes, Archive::Extent::kPhysics);
  EXPECT_THROW(archive(flag), TroubleError);
}

}  // namespace
}  // namespace sph
