#include "render/view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace sph {
namespace {

double Between(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0; }
Vec2 AnyPoint(double size) { return {Between(-size, size), Between(-size, size)}; }
View AnyView() {
  const Vec2 low = AnyPoint(10);
  const Vec2 size = {Between(0.01, 10), Between(0.01, 10)};
  return {{low.x, low.y, low.x + size.x, low.y + size.y}, *rc::gen::inRange(1, 4000), *rc::gen::inRange(1, 4000)};
}
bool Near(Vec2 a, Vec2 b, double tolerance) { return Length(a - b) <= tolerance; }

TEST(View, ShowsTheRegionWholeAndCentred) {
  EXPECT_TRUE(rc::check([] {
    const View view = AnyView();
    const Vec2 low = view.ToPixel({view.region.x0, view.region.y1});  // top left
    const Vec2 high = view.ToPixel({view.region.x1, view.region.y0});
    const double rounding = 1e-9 * (view.width + view.height);
    RC_ASSERT(low.x >= -rounding && low.y >= -rounding);
    RC_ASSERT(high.x <= view.width + rounding && high.y <= view.height + rounding);
    RC_ASSERT(std::abs(low.x + high.x - view.width) <= rounding && std::abs(low.y + high.y - view.height) <= rounding);
    RC_ASSERT(std::min(low.x, low.y) <= rounding);  // and as large as fits
  }));
}

TEST(View, HasOneScaleInXAndY) {
  EXPECT_TRUE(rc::check([] {
    const View view = AnyView();
    const Vec2 origin = view.ToPixel({0, 0});
    RC_ASSERT(Near(view.ToPixel({1, 0}) - origin, {view.Scale(), 0}, 1e-9 * view.Scale()));
    RC_ASSERT(Near(view.ToPixel({0, 1}) - origin, {0, -view.Scale()}, 1e-9 * view.Scale()));
  }));
}

TEST(View, GoesToPixelsAndBack) {
  EXPECT_TRUE(rc::check([] {
    const View view = AnyView();
    const Vec2 point = AnyPoint(10);
    RC_ASSERT(Near(view.ToPlane(view.ToPixel(point)), point, 1e-11));
  }));
}

TEST(View, KnowsWhatTheWindowsCornersShow) {
  EXPECT_TRUE(rc::check([] {
    const View view = AnyView();
    const Box visible = view.Visible();
    RC_ASSERT(Near(view.ToPlane({0, 0}), {visible.x0, visible.y1}, 1e-9));
    RC_ASSERT(Near(view.ToPlane({double(view.width), double(view.height)}), {visible.x1, visible.y0}, 1e-9));
  }));
}

TEST(View, ZoomsAboutAPixelThatStaysWhereItIs) {
  EXPECT_TRUE(rc::check([] {
    const View view = AnyView();
    const Vec2 pixel = {Between(0, view.width), Between(0, view.height)};
    const double factor = Between(0.1, 10);
    const View zoomed = view.ZoomedAbout(pixel, factor);
    RC_ASSERT(std::abs(zoomed.Scale() / (factor * view.Scale()) - 1) < 1e-9);
    RC_ASSERT(Near(zoomed.ToPixel(view.ToPlane(pixel)), pixel, 1e-6));
  }));
}

TEST(View, PansByPixels) {
  EXPECT_TRUE(rc::check([] {
    const View view = AnyView();
    const Vec2 moved = AnyPoint(500);
    const Vec2 point = AnyPoint(10);
    RC_ASSERT(Near(view.Panned(moved).ToPixel(point), view.ToPixel(point) + moved, 1e-6));
  }));
}

TEST(View, OfAContentKeepsTheMarginsFree) {
  for (const auto& [width, height] : {std::pair(1280, 720), {900, 1600}, {320, 240}}) {
    const Box content = {-1, -2, 3, 1};
    const View view = ViewOf(content, width, height, 12, 30);
    const Vec2 low = view.ToPixel({content.x0, content.y1});
    const Vec2 high = view.ToPixel({content.x1, content.y0});
    EXPECT_GE(low.x, 12 - 1e-9);
    EXPECT_GE(low.y, 30 - 1e-9);
    EXPECT_LE(high.x, width - 12 + 1e-9);
    EXPECT_LE(high.y, height - 12 + 1e-9);
    EXPECT_TRUE(std::abs(low.x - 12) < 1e-9 || std::abs(low.y - 30) < 1e-9) << "as large as the margins allow";
  }
}

TEST(View, OfAContentStaysUsableInAWindowSmallerThanTheMargins) {
  const View view = ViewOf({0, 0, 1, 1}, 8, 5, 12, 30);
  EXPECT_GE(view.Scale(), 2.5 - 1e-9);  // half the window's height is left to the content
}

}  // namespace
}  // namespace sph
