#include "lab/plot_legend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "lab/pixels.hpp"
#include "lab/plot_style.hpp"

namespace sph {
namespace {

/// Marks densely in the unit square, but for the square [x, x + 0.5] x [y, y + 0.5].
Plot CrowdedBut(double x, double y) {
  Series crowd = {.name = "crowd", .line = Line::kNone, .marker = Marker::kDisk};
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 60; ++j) {
      const double px = i / 60.0, py = j / 60.0;
      if (px > x && px < x + 0.5 && py > y && py < y + 0.5) continue;
      crowd.x.push_back(px);
      crowd.y.push_back(py);
    }
  }
  return UnitSquare(crowd);
}

Image WithoutNames(Plot plot, int width, int height) {
  for (Series& series : plot.series) series.name.clear();
  return Draw(plot, width, height);
}

TEST(Legend, TakesTheEmptiestCorner) {
  for (const double x : {0.0, 0.5}) {
    for (const double y : {0.0, 0.5}) {
      const Plot plot = CrowdedBut(x, y);
      const Box frame = LayOut(plot, 1200, 800).frame;
      const Box legend = DifferenceOf(Draw(plot), WithoutNames(plot, 1200, 800));
      const Vec2 c = frame.Centre();
      EXPECT_TRUE(x > 0 ? legend.x0 > c.x : legend.x1 < c.x) << x << " " << y;
      EXPECT_TRUE(y > 0 ? legend.y1 < c.y : legend.y0 > c.y) << x << " " << y;
      EXPECT_GE(legend.x0, frame.x0);
      EXPECT_LE(legend.x1, frame.x1);
    }
  }
}

TEST(Legend, StandsBesideThePlotWhereNoCornerIsEmpty) {
  const Plot plot = CrowdedBut(2, 2);
  const Vec2 size = LegendSize(plot, 1);
  const Box frame = LayOut(plot, 1200, 800, size).frame;
  const Image image = Draw(plot);
  EXPECT_LT(frame.x1 + size.x, 1200);
  EXPECT_GT(CountOfColour(image, {frame.x1 + 10, 0, 1200, 800}, kRed), 50) << "the sample's marker";
  EXPECT_GT(CountOfColour(image, {frame.x1 + 10, 0, 1200, 800}, kInk), 100) << "the name";
}

TEST(Legend, NamesEverySeriesAndBand) {
  Plot plot;
  plot.series = {Curve("alpha", {0, 1}, {0, 0}), Theory("beta", {0, 1}, {0, 0.1}), Curve("", {0, 1}, {0, 0.2})};
  const double two = LegendSize(plot, 1).y;
  plot.bands = {{.name = "gamma", .x = {0, 1}, .low = {0, 0}, .high = {0, 0.1}}};
  const double three = LegendSize(plot, 1).y;
  EXPECT_DOUBLE_EQ(three - two, LineHeight(kLegendSize)) << "one line each; what has no name has none";

  // Drawn alone, each of the lines has a sample on the left and letters on the right.
  Surface surface(400, 200);
  const Vec2 size = LegendSize(plot, 1);
  DrawLegend(surface, plot, {10, 10, 10 + size.x, 10 + size.y}, 1);
  const Image image = surface.ToImage();
  for (int line = 0; line < 3; ++line) {
    const double y0 = std::round(16 + line * LineHeight(kLegendSize)), y1 = std::floor(y0 + LineHeight(kLegendSize));
    const Box sample = {22, y0, 78, y1}, name = {90, y0, 10 + size.x, y1};
    EXPECT_GT(CountInk(image, sample), 80) << line;
    EXPECT_GT(CountOfColour(image, name, kInk), 80) << line;
  }
}

TEST(Legend, IsNotThereWithoutNames) {
  Plot plot = UnitSquare({.x = {0, 1}, .y = {0, 1}});
  EXPECT_EQ(LegendSize(plot, 1), Vec2{});
  plot.series[0].name = "line";
  EXPECT_GT(LegendSize(plot, 1).x, WidthOfText("line", kLegendSize));
}

TEST(Style, GivesEverySeriesAnotherLook) {
  Plot plot;
  for (int i = 0; i < 49; ++i) plot.series.push_back(Curve("", {}, {}));
  std::set<std::pair<double, Marker>> looks;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series series = Styled(plot, i);
    looks.insert({series.colour->red + 2 * series.colour->green + 4 * series.colour->blue, series.marker});
  }
  EXPECT_EQ(looks.size(), plot.series.size());
}

TEST(Style, PaletteIsThatOfOkabeAndIto) {
  // In the publication's table of 8-bit values; vermillion and blue, on which most plots rely.
  EXPECT_LT(Distance(kPalette[0], {0, 114 / 255.0, 178 / 255.0}), 1e-12);
  EXPECT_LT(Distance(kPalette[1], {213 / 255.0, 94 / 255.0, 0}), 1e-12);
}

TEST(Style, CrowdsOfPointsAreSmallAndTransparent) {
  const Series few = Scatter("", std::vector<double>(50), std::vector<double>(50));
  const Series many = Scatter("", std::vector<double>(3000), std::vector<double>(3000));
  EXPECT_EQ(few.opacity, 1);
  EXPECT_LT(many.opacity, 0.6);
  EXPECT_LT(many.marker_size, 0.6 * few.marker_size);
}

TEST(Text, StandsWhereItsAnchorIs) {
  for (const auto& [anchor, from] : {std::pair{Anchor::kLeft, 0.0}, {Anchor::kMiddle, -0.5}, {Anchor::kRight, -1.0}}) {
    Surface surface(400, 100);
    surface.SetColour({0, 0, 0});
    DrawText(surface, "HHH", {200, 50}, 40, anchor);
    const double width = WidthOfText("HHH", 40);
    const Box ink = DifferenceOf(surface.ToImage(), Surface(400, 100).ToImage());
    // Letters begin and end a tenth of their size inside their advance.
    EXPECT_NEAR(ink.x0, 200 + from * width, 5);
    EXPECT_NEAR(ink.x1, 200 + from * width + width, 5);
    EXPECT_NEAR(0.5 * (ink.y0 + ink.y1), 50, 1);
    EXPECT_NEAR(ink.y1 - ink.y0, 0.73 * 40, 2) << "the height of DejaVu's capitals";
  }
}

TEST(Text, WrapsBetweenWordsAndShrinksToFit) {
  EXPECT_EQ(Wrap("one two three", 20, 1000), std::vector<std::string>{"one two three"});
  EXPECT_EQ(Wrap("one two three", 20, WidthOfText("one two", 20) + 1), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(Wrap("at t = 0.5 s or so", 20, WidthOfText("at t = 0.5", 20)),
            (std::vector<std::string>{"at", "t = 0.5 s", "or so"}));
  EXPECT_EQ(Wrap("immeasurable", 20, 5), std::vector<std::string>{"immeasurable"});
  EXPECT_TRUE(Wrap("", 20, 100).empty());
  EXPECT_EQ(FittingSize("abc", 20, 1000), 20);
  EXPECT_NEAR(WidthOfText("abc", FittingSize("abc", 20, 10)), 10, 0.5);
}

}  // namespace
}  // namespace sph
