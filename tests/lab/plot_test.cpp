#include "lab/plot.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lab/pixels.hpp"
#include "lab/plot_layout.hpp"

namespace sph {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kWidth = 600, kHeight = 400;

Series Points(std::vector<double> x, std::vector<double> y, Marker marker = Marker::kDisk) {
  return {.x = std::move(x), .y = std::move(y), .line = Line::kNone, .marker = marker};
}

TEST(Draw, GivesAPictureOfTheSizeAskedFor) {
  const Image image = Draw({}, 321, 123);
  EXPECT_EQ(image.width, 321);
  EXPECT_EQ(image.height, 123);
  EXPECT_EQ(image.rgb.size(), 3U * 321 * 123);
}

TEST(Draw, PutsAPointAtThePixelOfItsValues) {
  for (const Scale scale : {Scale::kLinear, Scale::kLog}) {
    Plot plot = UnitSquare(Points({0.3}, {0.05}));
    plot.x.scale = plot.y.scale = scale;
    plot.x.low = plot.y.low = 0.01;
    const Image image = Draw(plot, kWidth, kHeight);
    const PlotLayout layout = LayOut(plot, kWidth, kHeight);
    // By hand: the part of the axis, in decades of two on the logarithmic one.
    const double part_x = scale == Scale::kLog ? (std::log10(0.3) + 2) / 2 : 0.29 / 0.99;
    const double part_y = scale == Scale::kLog ? (std::log10(0.05) + 2) / 2 : 0.04 / 0.99;
    const double x = layout.frame.x0 + part_x * layout.frame.Width();
    const double y = layout.frame.y1 - part_y * layout.frame.Height();
    EXPECT_LT(Distance(PixelAt(image, x, y), kRed), 0.02);
    const double all = CountOfColour(image, WholeOf(image), kRed);
    const double here = CountOfColour(image, {x - 4, y - 4, x + 4, y + 4}, kRed);
    EXPECT_EQ(here, all) << "a disk of 6 pixels and nothing else is red";
    EXPECT_GE(here, 16);
  }
}

TEST(Draw, GivesEveryMarkerAboutTheSameInk) {
  const double disk = CountOfColour(Draw(UnitSquare(Points({0.5}, {0.5}))), {0, 0, 1200, 800}, kRed);
  EXPECT_NEAR(disk, 0.25 * 3.1416 * 12 * 12, 15);
  for (const Marker marker :
       {Marker::kSquare, Marker::kTriangle, Marker::kDiamond, Marker::kDownTriangle, Marker::kCross, Marker::kPlus}) {
    const double ink = CountOfColour(Draw(UnitSquare(Points({0.5}, {0.5}, marker))), {0, 0, 1200, 800}, kRed);
    EXPECT_NEAR(ink, disk, 0.4 * disk) << static_cast<int>(marker);
  }
}

TEST(Draw, CutsLinesAtTheFrame) {
  for (const double far : {2.0, 1e9, 1e200}) {
    const Plot plot = UnitSquare({.x = {-far, far}, .y = {-far, far}});
    const Image image = Draw(plot);
    const Box frame = LayOut(plot, 1200, 800).frame;
    const Box with_line_width = {frame.x0 - 2, frame.y0 - 2, frame.x1 + 2, frame.y1 + 2};
    EXPECT_EQ(CountOfColour(image, with_line_width, kRed), CountOfColour(image, WholeOf(image), kRed)) << far;
    if (far > 1e15) continue;  // doubles do not know where such a line passes
    const Vec2 c = frame.Centre();
    EXPECT_GE(CountOfColour(image, {c.x - 2, c.y - 2, c.x + 2, c.y + 2}, kRed), 6) << "y = x passes the centre";
    EXPECT_EQ(CountOfColour(image, {frame.x0, frame.y0, c.x - 10, c.y - 10}, kRed), 0) << far;
    EXPECT_GT(CountOfColour(image, {frame.x0, c.y + 10, c.x - 10, frame.y1}, kRed), 1000) << far;
  }
}

TEST(Draw, InterruptsLinesWhereAValueIsMissing) {
  for (const double missing : {kNan, kInfinity, -kInfinity}) {
    const Plot plot = UnitSquare({.x = {0.1, 0.3, 0.5, 0.7, 0.9}, .y = {0.5, 0.5, missing, 0.5, 0.5}});
    const Image image = Draw(plot);
    const PlotLayout layout = LayOut(plot, 1200, 800);
    const auto red_between = [&](double a, double b) {
      const double y = layout.y.ToPixel(0.5);
      return CountOfColour(image, {layout.x.ToPixel(a), y - 4, layout.x.ToPixel(b), y + 4}, kRed);
    };
    EXPECT_GT(red_between(0.1, 0.3), 50);
    EXPECT_EQ(red_between(0.31, 0.69), 0);
    EXPECT_GT(red_between(0.7, 0.9), 50);
  }
}

TEST(Draw, LeavesGapsInDashedLinesOnly) {
  Series series = {.x = {0, 1}, .y = {0.5, 0.5}};
  const auto red = [&](Line line) {
    series.line = line;
    const Image image = Draw(UnitSquare(series));
    return CountOfColour(image, WholeOf(image), kRed);
  };
  const double solid = red(Line::kSolid);
  EXPECT_NEAR(red(Line::kDashed) / solid, 4 / 6.5, 0.15);
  EXPECT_LT(red(Line::kDotted), 0.6 * solid);
  EXPECT_GT(red(Line::kDotted), 0.1 * solid);
  EXPECT_EQ(red(Line::kNone), 0);
}

TEST(Draw, FillsBandsBetweenTheirEdges) {
  Plot plot = UnitSquare({});
  plot.bands = {{.x = {0.2, 0.8}, .low = {0.4, 0.4}, .high = {0.6, 0.6}, .colour = Colour{0, 0, 1}, .opacity = 1},
                {.x = {0.1, 0.2}, .high = {0.2, 0.2}, .colour = Colour{0, 0, 1}, .opacity = 1}};
  const Image image = Draw(plot, kWidth, kHeight);
  const PlotLayout layout = LayOut(plot, kWidth, kHeight);
  const auto blue = [&](double x, double y) {
    return Distance(PixelAt(image, layout.x.ToPixel(x), layout.y.ToPixel(y)), {0, 0, 1}) < 0.1;
  };
  EXPECT_TRUE(blue(0.5, 0.5));
  EXPECT_TRUE(blue(0.22, 0.58));
  EXPECT_FALSE(blue(0.5, 0.63));
  EXPECT_FALSE(blue(0.83, 0.5));
  EXPECT_TRUE(blue(0.15, 0.02)) << "a band without a lower edge reaches the axis";
}

TEST(Draw, GivesTheSamePictureTwice) {
  const Plot plot = UnitSquare(Scatter("points", {0.1, 0.5, 0.9}, {0.2, 0.4, 0.6}));
  EXPECT_EQ(Draw(plot), Draw(plot));
}

TEST(Omissions, CountWhatIsNotShownAndSayWhy) {
  Plot plot;
  plot.series = {Curve("run", {1, 2, 3, 4}, {1, kNan, 0, -1})};
  EXPECT_EQ(Omissions(plot), "Not shown: 1 of “run” (not a finite number).");
  plot.y.scale = Scale::kLog;
  EXPECT_EQ(Omissions(plot), "Not shown: 1 of “run” (not a finite number); 2 of “run” (not positive).");
  plot.series = {Curve("run", {1, 2}, {1, 5})};
  EXPECT_EQ(Omissions(plot), "");
  plot.y.high = 3;
  EXPECT_EQ(Omissions(plot), "Not shown: 1 of “run” (outside the axes).");
  plot.series[0].marker = Marker::kNone;
  EXPECT_EQ(Omissions(plot), "") << "a line is seen to leave the plot";
}

TEST(Omissions, StandUnderThePlot) {
  Plot all = UnitSquare(Points({0.5, 0.6}, {0.5, 0.5}));
  Plot one = UnitSquare(Points({0.5, 0.6}, {0.5, kNan}));
  EXPECT_GT(LayOut(all, kWidth, kHeight).frame.y1, LayOut(one, kWidth, kHeight).frame.y1);
  const double top = LayOut(one, kWidth, kHeight).note.top;
  const Box note = {0, top, kWidth, kHeight};
  EXPECT_GT(CountOfColour(Draw(one, kWidth, kHeight), note, {0.35, 0.35, 0.35}), 100);
}

TEST(DrawDeathTest, RefusesSeriesOfUnequalLengths) {
  EXPECT_DEATH(Draw(UnitSquare({.name = "lopsided", .x = {1, 2}, .y = {1}})), "lopsided");
  EXPECT_DEATH(Draw({}, 0, 100), "0 x 100");
}

}  // namespace
}  // namespace sph
