// Heat maps: each cell where it belongs, in the colour of its value.
#include <gtest/gtest.h>

#include <limits>

#include "lab/pixels.hpp"
#include "lab/plot_layout.hpp"
#include "lab/plot_style.hpp"

namespace sph {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Plot MapOf(std::vector<double> values, std::size_t columns, std::size_t rows, const Box& extent) {
  Plot plot;
  plot.map = HeatMap{columns, rows, std::move(values), extent, {}};
  return plot;
}

Colour ColourAt(const Plot& plot, double x, double y) {
  const PlotLayout layout = LayOut(plot, 1200, 800);
  return PixelAt(Draw(plot), layout.x.ToPixel(x), layout.y.ToPixel(y));
}

constexpr double kRounding = 1.0 / 255;

TEST(HeatMap, ShowsEachCellInTheColourOfItsValue) {
  const Plot plot = MapOf({0, 1, 2, 3, 4, kNan}, 3, 2, {0, 10, 3, 12});
  EXPECT_LE(Distance(ColourAt(plot, 0.5, 10.5), MapColour(0)), kRounding) << "the first value is at the lower left";
  EXPECT_LE(Distance(ColourAt(plot, 2.5, 10.5), MapColour(0.5)), kRounding);
  EXPECT_LE(Distance(ColourAt(plot, 1.5, 11.5), MapColour(1)), kRounding);
  EXPECT_LE(Distance(ColourAt(plot, 2.5, 11.5), kNoValueColour), kRounding);
  EXPECT_EQ(Omissions(plot), "Grey: no value (1 of 6 cells). ");
}

TEST(HeatMap, HasCellsOfConstantRatioOnALogarithmicAxis) {
  Plot plot = MapOf({0, 1, 0, 1}, 4, 1, {1, 0, 1e4, 1});
  plot.x.scale = Scale::kLog;
  EXPECT_LE(Distance(ColourAt(plot, 9, 0.5), MapColour(0)), kRounding);
  EXPECT_LE(Distance(ColourAt(plot, 11, 0.5), MapColour(1)), kRounding);
  EXPECT_LE(Distance(ColourAt(plot, 900, 0.5), MapColour(0)), kRounding);
}

TEST(HeatMap, FollowsTheScaleAndEndsOfItsColourBar) {
  Plot plot = MapOf({1e-4, 1e-2, 1, 100}, 4, 1, {0, 0, 4, 1});
  plot.map->value = {.scale = Scale::kLog, .high = 1};
  EXPECT_LE(Distance(ColourAt(plot, 1.5, 0.5), MapColour(0.5)), kRounding);
  EXPECT_LE(Distance(ColourAt(plot, 3.5, 0.5), MapColour(1)), kRounding) << "beyond the end: its colour";

  const PlotLayout layout = LayOut(plot, 1200, 800);
  const Image image = Draw(plot);
  const double middle = layout.bar.Centre().x;
  EXPECT_LE(Distance(PixelAt(image, middle, layout.bar_values.ToPixel(1e-2)), MapColour(0.5)), 2 * kRounding);
  EXPECT_GT(layout.bar.x0, layout.frame.x1);
}

TEST(HeatMap, HasNoSeamsBetweenCells) {
  constexpr std::size_t kColumns = 37, kRows = 23;
  const Plot plot = MapOf(std::vector<double>(kColumns * kRows, 1.0), kColumns, kRows, {0, 0, 1, 1});
  const Box frame = LayOut(plot, 1200, 800).frame;
  const Box inside = {frame.x0 + 2, frame.y0 + 2, frame.x1 - 2, frame.y1 - 2};
  const Image image = Draw(plot);
  const Colour colour = PixelAt(image, inside.x0, inside.y0);
  EXPECT_EQ(CountOfColour(image, inside, colour, 0), inside.Width() * inside.Height());
}

TEST(MapColour, GetsEverBrighter) {
  const auto luminance = [](Colour c) {  // ITU-R BT.709, of linear light
    const auto linear = [](double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
  };
  for (int i = 0; i < 100; ++i) EXPECT_LT(luminance(MapColour(i / 100.0)), luminance(MapColour((i + 1) / 100.0))) << i;
  EXPECT_LT(luminance(MapColour(0)), 0.02);
  EXPECT_GT(luminance(MapColour(1)), 0.7);
}

}  // namespace
}  // namespace sph
