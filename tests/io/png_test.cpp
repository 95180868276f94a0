#include "io/png.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>

#include "base/error.hpp"
#include "io/scratch.hpp"
#include "io/trouble.hpp"

namespace sph {
namespace {

/// A picture of any bytes, or of any greys.
Image AnyImage(int width, int height, bool grey) {
  Image image{width, height, {}};
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.rgb = *rc::gen::container<std::vector<std::uint8_t>>(3 * pixels, rc::gen::arbitrary<std::uint8_t>());
  for (std::size_t i = 0; grey && i < image.rgb.size(); ++i) image.rgb[i] = image.rgb[i - i % 3];
  return image;
}

TEST(Png, GivesBackEveryPixel) {
  EXPECT_TRUE(rc::check([](bool grey) {
    const Image image = AnyImage(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), grey);
    const ScratchDirectory scratch;
    WritePng(scratch.Path() / "frame.png", image);
    RC_ASSERT(ReadPng(scratch.Path() / "frame.png") == image);
  }));
}

TEST(Png, HasItsFirstRowAtTheTop) {
  Image image{1, 2, {255, 0, 0, 0, 0, 255}};  // red above blue
  const ScratchDirectory scratch;
  WritePng(scratch.Path() / "frame.png", image);
  const Image read = ReadPng(scratch.Path() / "frame.png");
  EXPECT_EQ(read.Pixel(0, 0)[0], 255);
  EXPECT_EQ(read.Pixel(0, 1)[2], 255);
}

TEST(Png, OfAWhiteFrameIsSmall) {
  const Image white{1280, 720, std::vector<std::uint8_t>(std::size_t{3} * 1280 * 720, 255)};
  EXPECT_LT(EncodePng(white).size(), 10'000U);
}

TEST(Png, IsNotLeftHalfWrittenOnAFullDisk) {
  Image noise{200, 200, std::vector<std::uint8_t>(std::size_t{3} * 200 * 200)};
  for (std::size_t i = 0; i < noise.rgb.size(); ++i)
    noise.rgb[i] = static_cast<std::uint8_t>(i * i * 2654435761U >> 13);
  const ScratchDirectory scratch;
  {
    const FullDisk full(1000);
    EXPECT_THROW(WritePng(scratch.Path() / "frame.png", noise), TroubleError);
  }
  EXPECT_EQ(scratch.Count(), 0);
}

TEST(Png, IsRefusedWithItsNameIfItIsMissingCutShortOrSomethingElse) {
  const ScratchDirectory scratch;
  const auto path = scratch.Path() / "frame.png";
  EXPECT_TRUE(Complains([&] { ReadPng(path); }, {"frame.png", "No such file"}));
  std::ofstream(path) << "not a picture";
  EXPECT_TRUE(Complains([&] { ReadPng(path); }, {"frame.png"}));
  WritePng(path, {20, 20, std::vector<std::uint8_t>(std::size_t{3} * 20 * 20, 7)});
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_TRUE(Complains([&] { ReadPng(path); }, {"frame.png"}));
}

}  // namespace
}  // namespace sph
