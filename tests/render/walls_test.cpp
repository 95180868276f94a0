// Walls on the screen: crisp, of the right width, and cut cleanly.
#include <gtest/gtest.h>

#include <cmath>

#include "render/picture.hpp"

namespace sph {
namespace {

constexpr double kWallInk = 1 - 64 / 255.0;  // a quarter of the light, as shaders/walls.frag has it, in 8 bits

TEST(Walls, AlongAnAxisAreThreeFullColumnsOfPixelsWhereverTheyStand) {
  Easel easel(100, 100);
  for (const double x : {50.0, 50.3, 50.5, 50.9}) {
    const Image image = easel.DrawInPixels(100, 100, [&](Canvas& c) { c.DrawWall({x, 20}, {x, 80}); });
    int columns = 0;
    for (int column = 0; column < 100; ++column) {
      const double ink = Ink(image, column, 50);
      EXPECT_TRUE(ink == 0 || ink == kWallInk) << ink;
      if (ink == 0) continue;
      ++columns;
      EXPECT_LE(std::abs(column + 0.5 - x), 2);
    }
    EXPECT_EQ(columns, 3);
  }
}

TEST(Walls, HaveTheSameWidthInEveryDirection) {
  Easel easel(200, 200);
  for (int degrees = 0; degrees < 180; degrees += 15) {
    const double angle = degrees * 3.14159265358979 / 180;
    const Vec2 half = {70 * std::cos(angle), 70 * std::sin(angle)};
    const Image image = easel.DrawInPixels(200, 200, [&](Canvas& c) {
      c.DrawWall(Vec2{100, 100} - half, Vec2{100, 100} + half);
    });
    // 140 pixels long, half the width over at each end. The ink of an oblique edge is a ramp, whose sum over the pixels
    // depends on where they cut it: at 45 degrees by 2 %.
    EXPECT_NEAR(Weigh(image).area / kWallInk, 3 * (140 + 3), 0.02 * 3 * 143) << degrees;
  }
}

TEST(Walls, FillTheCornerWhereTheyMeet) {
  Easel easel(100, 100);
  const Image image = easel.DrawInPixels(100, 100, [](Canvas& c) {
    c.DrawWall({20, 20}, {20, 80});
    c.DrawWall({20, 20}, {80, 20});
  });
  for (int x = 19; x <= 21; ++x) {
    for (int y = 78; y <= 80; ++y) EXPECT_GE(Ink(image, x, y), kWallInk) << x << " " << y;
  }
  EXPECT_EQ(Ink(image, 18, 79), 0);
}

TEST(Walls, AreWiderAtALargerUiScale) {
  Easel easel(100, 100, 2);
  const Image image = easel.DrawInPixels(100, 100, [](Canvas& c) { c.DrawWall({50, -10}, {50, 110}); });
  EXPECT_NEAR(Weigh(image).area, kWallInk * 6 * 100, 0.1);
}

TEST(Walls, ThatReachFarOutOfTheWindowLookLikeTheirVisiblePart) {
  Easel easel(100, 100);
  const Vec2 middle = {50, 40};
  const Vec2 direction = {3, 1};
  const auto picture = [&](double reach) {
    return easel.DrawInPixels(100, 100,
                              [&](Canvas& c) { c.DrawWall(middle - reach * direction, middle + reach * direction); });
  };
  const Image near = picture(100);
  EXPECT_LE(LargestDifference(near, picture(1e3)), 1);
  EXPECT_LE(LargestDifference(near, picture(1e9)), 1);
  EXPECT_GT(Weigh(near).area, 100);
}

TEST(Walls, ThatCannotBeSeenLeaveNoTrace) {
  Easel easel(100, 100);
  const Image image = easel.DrawInPixels(100, 100, [](Canvas& c) {
    c.DrawWall({-50, 0}, {-50, 100});
    c.DrawWall({0, 300}, {300, 120});
    c.DrawWall({std::nan(""), 0}, {50, 50});
  });
  EXPECT_EQ(image.rgb, std::vector<std::uint8_t>(std::size_t{3} * 100 * 100, 255));
}

}  // namespace
}  // namespace sph
