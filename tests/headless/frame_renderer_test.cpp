#include "headless/frame_renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/random.hpp"

namespace sph {
namespace {

constexpr Box kRegion = {-1, -1, 1, 1};

/// Disks of values, walls in all directions: something of everything that a frame can show.
void DrawScene(Canvas& canvas) {
  Random random(1);
  std::vector<double> x, y, values;
  for (int i = 0; i < 3000; ++i) {
    x.push_back(random.Uniform(-1.5, 1.5));
    y.push_back(random.Uniform(-0.9, 0.3));
    values.push_back(random.Uniform());
  }
  const bool black = canvas.WantedColouring() == Colouring::kBlackDisks;
  canvas.DrawDisks(x, y, 0.011, black ? std::span<const double>() : values);
  canvas.DrawDisks(std::span(x).first(2), std::span(y).first(2), 0.8, {});
  canvas.DrawWall({-0.9, -0.9}, {0.9, -0.9});
  canvas.DrawWall({-0.9, -0.9}, {0.7, 0.8});
}

const FrameText kText = {"dam-break   t = 1.234 s   N = 3000", "the dam is broken"};

TEST(FrameRenderer, DrawsTheSamePixelsWithEitherBackend) {
  for (const auto& [width, height] : {std::pair(320, 240), {1280, 720}, {450, 800}}) {
    FrameRenderer osmesa(Backend::kOsmesa, width, height);
    FrameRenderer egl(Backend::kEgl, width, height);
    if (egl.GlDescription() != osmesa.GlDescription()) {
      GTEST_SKIP() << "EGL draws with another driver here: " << egl.GlDescription();
    }
    for (const Colouring colouring : {Colouring::kBlackDisks, Colouring::kDensity}) {
      EXPECT_EQ(osmesa.Render(kRegion, colouring, DrawScene, kText), egl.Render(kRegion, colouring, DrawScene, kText));
    }
  }
}

TEST(FrameRenderer, GivesAPictureOfTheSizeAskedFor) {
  FrameRenderer frames(Backend::kAuto, 333, 217);
  const Image image = frames.Render(kRegion, Colouring::kBlackDisks, DrawScene);
  EXPECT_EQ(image.width, 333);
  EXPECT_EQ(image.height, 217);
  EXPECT_EQ(image.rgb.size(), std::size_t{3} * 333 * 217);
  EXPECT_EQ(frames.Width(), 333);
  EXPECT_EQ(frames.Height(), 217);
  EXPECT_EQ(frames.BackendName(), "osmesa");
}

TEST(FrameRenderer, AsksForTheColouringAndShowsIt) {
  FrameRenderer frames(Backend::kAuto, 320, 240);
  const auto has_colour = [](const Image& image) {
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      if (image.rgb[i] != image.rgb[i + 2]) return true;
    }
    return false;
  };
  EXPECT_FALSE(has_colour(frames.Render(kRegion, Colouring::kBlackDisks, DrawScene, kText)));
  EXPECT_TRUE(has_colour(frames.Render(kRegion, Colouring::kSpeed, DrawScene, kText)));
}

TEST(FrameRenderer, KeepsAColourRangeFromFrameToFrame) {
  FrameRenderer frames(Backend::kAuto, 320, 240);
  const Image fitted = frames.Render(kRegion, Colouring::kSpeed, DrawScene);
  frames.SetColourRange(ColourRange{0, 50});
  const Image fixed = frames.Render(kRegion, Colouring::kSpeed, DrawScene);
  EXPECT_NE(fitted, fixed);
  EXPECT_EQ(fixed, frames.Render(kRegion, Colouring::kSpeed, DrawScene));
  frames.SetColourRange(std::nullopt);
  EXPECT_EQ(fitted, frames.Render(kRegion, Colouring::kSpeed, DrawScene));
}

TEST(FrameRenderer, WorksBesideOthersAndAfterTheirEnd) {
  auto first = std::make_unique<FrameRenderer>(Backend::kOsmesa, 200, 100);
  FrameRenderer second(Backend::kEgl, 100, 200);
  const Image before = second.Render(kRegion, Colouring::kSpeed, DrawScene, kText);
  first->Render(kRegion, Colouring::kSpeed, DrawScene);
  EXPECT_EQ(before, second.Render(kRegion, Colouring::kSpeed, DrawScene, kText));
  first.reset();
  EXPECT_EQ(before, second.Render(kRegion, Colouring::kSpeed, DrawScene, kText));
}

TEST(FrameRenderer, GoesOnAfterAFrameWhoseDrawingFailed) {
  FrameRenderer frames(Backend::kAuto, 200, 100);
  const Image before = frames.Render(kRegion, Colouring::kSpeed, DrawScene);
  const auto fail = [](Canvas& canvas) {
    DrawScene(canvas);
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(frames.Render(kRegion, Colouring::kSpeed, fail), std::runtime_error);
  EXPECT_EQ(before, frames.Render(kRegion, Colouring::kSpeed, DrawScene));
}

}  // namespace
}  // namespace sph
