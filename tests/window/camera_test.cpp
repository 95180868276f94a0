// What the window shows: the scene whole and undistorted in a window of any shape, clear of the text.
#include "window/camera.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

constexpr Box kSquare{-1, -1, 1, 1};

View Seen(const Box& content, PixelSize window, double ui_scale = 1) {
  Camera camera;
  camera.Resize(window, ui_scale);
  camera.Fit(content);
  return camera.CurrentView();
}

TEST(Camera, ShowsTheContentWholeInAWindowOfAnyShape) {
  for (const Box& content : {kSquare, Box{0, 0, 1200, 900}, Box{5, 5, 6, 25}}) {
    for (const PixelSize window : {PixelSize{800, 800}, {1920, 1080}, {200, 1000}, {1000, 150}, {40, 40}, {1, 1}}) {
      const View view = Seen(content, window);
      EXPECT_EQ(view.width, window.width);
      EXPECT_EQ(view.height, window.height);
      const Vec2 low = view.ToPixel({content.x0, content.y0});
      const Vec2 high = view.ToPixel({content.x1, content.y1});
      EXPECT_GE(low.x, 0);
      EXPECT_LE(low.y, window.height);
      EXPECT_LE(high.x, window.width);
      EXPECT_GE(high.y, 0);
    }
  }
}

TEST(Camera, HasTheSameScaleInBothDirections) {
  for (const PixelSize window : {PixelSize{800, 800}, {1920, 1080}, {200, 1000}, {1000, 150}}) {
    const View view = Seen(kSquare, window);
    const Vec2 origin = view.ToPixel({0, 0});
    EXPECT_NEAR(view.ToPixel({1, 0}).x - origin.x, view.Scale(), 1e-9);
    EXPECT_NEAR(origin.y - view.ToPixel({0, 1}).y, view.Scale(), 1e-9);
  }
}

TEST(Camera, KeepsTheContentClearOfTheText) {
  for (const double ui_scale : {1.0, 2.0}) {
    for (const PixelSize window : {PixelSize{800, 800}, {1920, 1080}, {1100, 700}, {400, 1000}}) {
      const View view = Seen(kSquare, window, ui_scale);
      const Vec2 low = view.ToPixel({kSquare.x0, kSquare.y0});
      const Vec2 high = view.ToPixel({kSquare.x1, kSquare.y1});
      // Status line: 15 pixels of text and its veil at the left; legend: three such rows at the right.
      EXPECT_TRUE(high.y >= 35 * ui_scale || low.x >= 600 * ui_scale);
      EXPECT_TRUE(high.y >= 70 * ui_scale || high.x <= window.width - 210 * ui_scale);
      EXPECT_LE(low.y, window.height - 35 * ui_scale);
    }
  }
}

TEST(Camera, UsesMostOfTheWindow) {
  const View view = Seen(kSquare, {800, 800});
  EXPECT_GE(view.Scale() * kSquare.Width(), 0.8 * 800);
}

TEST(Camera, TheFirstWindowHasTheShapeOfTheContentAndFitsTheScreen) {
  for (const Box& content : {kSquare, Box{0, 0, 12, 9}, Box{0, 0, 10, 1}, Box{0, 0, 1, 10}}) {
    for (const PixelSize screen : {PixelSize{1280, 1024}, {1920, 1080}, {3840, 2160}, {800, 600}}) {
      const PixelSize size = FirstWindowSize(content, screen, 1);
      EXPECT_GT(size.width, 0);
      EXPECT_GT(size.height, 0);
      EXPECT_LE(size.width, screen.width);
      EXPECT_LE(size.height, screen.height);
    }
  }
  const PixelSize wide = FirstWindowSize({0, 0, 10, 1}, {1920, 1080}, 1);
  EXPECT_GT(wide.width, 3 * wide.height);
}

}  // namespace
}  // namespace sph
