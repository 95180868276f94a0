// Disks on the screen: size, shape, place and colour.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "render/colour_map.hpp"
#include "render/picture.hpp"

namespace sph {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void DrawOne(Canvas& canvas, Vec2 centre, double radius) {
  canvas.DrawDisks({&centre.x, 1}, {&centre.y, 1}, radius, {});
}

/// Disks that do not touch, at random places in their cells of a lattice that fills the view.
struct Lattice {
  std::vector<double> x, y;

  Lattice(const View& view, double radius) {
    Random random(1);
    const Box box = view.Visible();
    const double pixel = 1 / view.Scale();
    const double cell = 2 * radius + 4 * pixel;
    for (double x0 = box.x0 + pixel; x0 + cell + pixel < box.x1; x0 += cell) {
      for (double y0 = box.y0 + pixel; y0 + cell + pixel < box.y1; y0 += cell) {
        x.push_back(x0 + random.Uniform(radius + pixel, cell - radius - pixel));
        y.push_back(y0 + random.Uniform(radius + pixel, cell - radius - pixel));
      }
    }
  }
};

struct SizeCase {
  int width, height;  // of the window [pixels]
  double radius;      // [pixels]
};

class DisksOfASize : public testing::TestWithParam<SizeCase> {};

// A single disk's ink depends on where it lies between the pixels: computed, the standard deviation is 5 % at radius
// 0.3 (over 600 disks here, so 0.2 % of the mean), 1 % at 2, 0.03 % at 10 pixels. Rounding to 8 bits may shift each of
// the edge's pixels by 0.2 %, at random. So 1 % of the mean is far out.
TEST_P(DisksOfASize, HaveTheInkOfTrueDisks) {
  const auto [width, height, pixels] = GetParam();
  Easel easel(width, height);
  for (const double metres_across : {1e-3, 2.0, 7e5}) {
    const View view{{-metres_across, 0, 0, metres_across}, width, height};
    const double radius = pixels / view.Scale();
    const Lattice disks(view, radius);
    ASSERT_FALSE(disks.x.empty());
    const Image image =
        easel.Draw(view, Colouring::kBlackDisks, [&](Canvas& c) { c.DrawDisks(disks.x, disks.y, radius, {}); });
    const double area = std::numbers::pi * pixels * pixels;
    EXPECT_NEAR(Weigh(image).area / static_cast<double>(disks.x.size()), area, 0.01 * area) << metres_across << " m";
  }
}

INSTANTIATE_TEST_SUITE_P(AtAnyZoomAndShape, DisksOfASize,
                         testing::Values(SizeCase{160, 120, 0.3}, SizeCase{160, 120, 0.55}, SizeCase{160, 120, 0.7},
                                         SizeCase{320, 240, 1}, SizeCase{500, 100, 2}, SizeCase{100, 500, 2},
                                         SizeCase{333, 217, 5}, SizeCase{400, 400, 33.3}, SizeCase{300, 260, 100},
                                         SizeCase{301, 299, 126}, SizeCase{301, 299, 127.5}, SizeCase{640, 480, 200}));

TEST(Disks, AreRound) {
  Easel easel(64, 64);
  for (const double radius : {0.4, 2.0, 13.7, 30.0}) {
    const Image image = easel.DrawInPixels(64, 64, [&](Canvas& c) { DrawOne(c, {32, 32}, radius); });
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(Ink(image, x, y), Ink(image, y, x));
        EXPECT_EQ(Ink(image, x, y), Ink(image, 63 - x, y));
        const double distance = std::hypot(x - 31.5, y - 31.5);
        if (distance < radius - 1) {
          EXPECT_EQ(Ink(image, x, y), 1) << x << " " << y;
        } else if (distance > radius + 1) {
          EXPECT_EQ(Ink(image, x, y), 0) << x << " " << y;
        }
      }
    }
  }
}

TEST(Disks, AreWhereTheViewSaysEvenFarFromTheOrigin) {
  Easel easel(200, 150);
  for (const double far : {0.0, -3e3, 1e7}) {
    const View view{{far, far, far + 2, far + 1}, 200, 150};
    const Vec2 centre = {far + 0.7123, far + 0.3456};
    const Image image = easel.Draw(view, Colouring::kBlackDisks, [&](Canvas& c) { DrawOne(c, centre, 0.1); });
    const Vec2 expected = view.ToPixel(centre);
    const Vec2 found = Weigh(image).centre;
    EXPECT_NEAR(found.x, expected.x, 0.02) << far;  // the pixels sample the smooth edge
    EXPECT_NEAR(found.y, expected.y, 0.02) << far;
  }
}

// A window that shows a part of another's picture shows the same pixels, wherever its border cuts a disk: with centres
// outside, with disks as small as a point and larger than any point sprite. Rounding may differ in the last bit.
TEST(Disks, AreCutCleanlyByTheWindowsBorder) {
  Easel easel(600, 600);
  for (const double radius : {0.5, 4.0, 60.0, 150.0}) {
    const auto draw = [radius](Canvas& c) {
      for (const double d : {-0.6, -0.1, 0.3, 0.9}) {
        DrawOne(c, {200 - d * radius, 300.2}, radius);
        DrawOne(c, {300.7, 400 + d * radius}, radius);
        DrawOne(c, {400 + d * radius, 200 - 0.7 * radius}, radius);
      }
    };
    const Image whole = easel.DrawInPixels(600, 600, draw);
    const Image part = easel.Draw({{200, 200, 400, 400}, 200, 200}, Colouring::kBlackDisks, draw);
    EXPECT_LE(LargestDifference(part, Crop(whole, 200, 200, 200, 200)), 1) << radius;
    EXPECT_GT(Weigh(part).area, 1) << radius;
  }
}

TEST(Disks, AreDrawnInAsManyCallsAsOneLikes) {
  Easel easel(100, 100);
  const std::vector<double> x = {20, 50, 80};
  const std::vector<double> y = {30, 60, 40};
  const Image at_once = easel.DrawInPixels(100, 100, [&](Canvas& c) { c.DrawDisks(x, y, 7, {}); });
  const Image one_by_one = easel.DrawInPixels(100, 100, [&](Canvas& c) {
    for (std::size_t i = 0; i < 3; ++i) DrawOne(c, {x[i], y[i]}, 7);
  });
  EXPECT_EQ(at_once, one_by_one);
}

TEST(Disks, ThatAreNowhereOrFarAwayLeaveTheOthersAsTheyAre) {
  Easel easel(100, 100);
  const Image one = easel.DrawInPixels(100, 100, [](Canvas& c) { DrawOne(c, {50, 50}, 10); });
  const Image many = easel.DrawInPixels(100, 100, [](Canvas& c) {
    const std::vector<double> x = {kNaN, 50, std::numeric_limits<double>::infinity(), 1e300, -40, 50};
    const std::vector<double> y = {50, kNaN, 50, -1e300, 50, 50};
    c.DrawDisks(x, y, 10, {});
    c.DrawDisks({}, {}, 10, {});
  });
  EXPECT_EQ(one, many);
}

TEST(Disks, HaveTheColourOfTheirValue) {
  Easel easel(400, 400);
  const std::vector<double> x = {50, 150, 250, 350, 50};
  const std::vector<double> y = {50, 50, 50, 50, 150};
  const std::vector<double> values = {-2, 0, 1, 8, kNaN};
  const auto draw = [&](Canvas& c) { c.DrawDisks(x, y, 20, values); };
  const View view{{0, 0, 400, 400}, 400, 400};
  const auto colour_at = [&](const Image& image, std::size_t i) {
    const std::uint8_t* pixel = image.Pixel(static_cast<int>(x[i]), 400 - static_cast<int>(y[i]));
    return Rgb{pixel[0], pixel[1], pixel[2]};
  };
  const Image fitted = easel.Draw(view, Colouring::kPressure, draw);
  EXPECT_EQ(easel.GetRenderer().ShownRange(), (ColourRange{-2, 8}));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(colour_at(fitted, i), ColourAt((values[i] + 2) / 10)) << values[i];
  EXPECT_EQ(colour_at(fitted, 4), kNotANumberColour);

  easel.GetRenderer().SetColourRange(ColourRange{0, 2});
  const Image fixed = easel.Draw(view, Colouring::kPressure, draw);
  EXPECT_EQ(colour_at(fixed, 0), ColourAt(0));
  EXPECT_EQ(colour_at(fixed, 2), ColourAt(0.5));
  EXPECT_EQ(colour_at(fixed, 3), ColourAt(1));
}

TEST(Disks, AreDrawnTheSameTwice) {
  Easel easel(300, 200);
  const View view{{0, 0, 3, 2}, 300, 200};
  const Lattice disks(view, 0.02);
  const auto draw = [&](Canvas& c) { c.DrawDisks(disks.x, disks.y, 0.05, disks.y); };
  const Image first = easel.Draw(view, Colouring::kSpeed, draw);
  EXPECT_EQ(first, easel.Draw(view, Colouring::kSpeed, draw));
  EXPECT_EQ(first, Easel(300, 200).Draw(view, Colouring::kSpeed, draw));
}

}  // namespace
}  // namespace sph
