#include "render/legend.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "render/colour_map.hpp"
#include "render/picture.hpp"

namespace sph {
namespace {

TEST(Legend, NamesQuantityAndUnit) {
  EXPECT_EQ(QuantityTitle(Colouring::kSpeed), "speed [m/s]");
  EXPECT_EQ(QuantityTitle(Colouring::kPressure), "pressure [Pa]");
  EXPECT_EQ(QuantityTitle(Colouring::kDensity), "density [kg/m³]");
}

TEST(Legend, WritesTheEndsWithTheDigitsThatTellThemApart) {
  const auto ends = [](double low, double high) {
    const LegendText legend = LegendOf(Colouring::kSpeed, {low, high});
    return legend.low + " to " + legend.high;
  };
  EXPECT_EQ(ends(0, 1), "0 to 1.00");
  EXPECT_EQ(ends(-350, 19620), "-350 to 19620");
  EXPECT_EQ(ends(999.98, 1000.03), "999.9800 to 1000.0300");
  EXPECT_EQ(ends(0, 2.5e-4), "0 to 0.000250");
  EXPECT_EQ(ends(0, 3.456e-9), "0.00e+00 to 3.46e-09");
  EXPECT_EQ(ends(1e8, 3e8), "1.000e+08 to 3.000e+08");
}

TEST(Legend, IsInThePictureOfValuesOnly) {
  Easel easel(1280, 720);
  const View view{{0, 0, 1280, 720}, 1280, 720};
  const std::vector<double> x = {100, 200};
  const std::vector<double> y = {100, 100};
  const std::vector<double> values = {1, 2};
  const Image black = easel.Draw(view, Colouring::kBlackDisks, [&](Canvas& c) { c.DrawDisks(x, y, 5, {}); });
  const Image coloured = easel.Draw(view, Colouring::kSpeed, [&](Canvas& c) { c.DrawDisks(x, y, 5, values); });
  EXPECT_EQ(Weigh(Crop(black, 640, 0, 640, 360)).area, 0);
  const Image corner = Crop(coloured, 640, 0, 640, 360);
  EXPECT_GT(Weigh(corner).area, 500);

  // The bar is the colour map, left to right: some row of pixels shows every colour in turn.
  const auto is_the_bar = [&corner](int row) {
    int shown = 0;
    for (int column = 0; column < corner.width; ++column) {
      const std::uint8_t* pixel = corner.Pixel(column, row);
      const Rgb next = ColourAt((shown + 0.5) / 180);
      if (shown < 180 && std::abs(pixel[0] - next.red) + std::abs(pixel[1] - next.green) < 8) ++shown;
    }
    return shown >= 170;
  };
  bool found = false;
  for (int row = 0; row < corner.height && !found; ++row) found = is_the_bar(row);
  EXPECT_TRUE(found);
}

TEST(RangeFit, SpansTheFiniteValues) {
  RangeFit fit;
  EXPECT_FALSE(fit.Range());
  fit.Add(std::vector<double>{3, std::numeric_limits<double>::quiet_NaN(), -1});
  fit.Add(std::vector<double>{std::numeric_limits<double>::infinity(), 2});
  EXPECT_EQ(fit.Range(), (ColourRange{-1, 3}));
}

TEST(RangeFit, IsNeverEmpty) {
  for (const double value : {0.0, 1000.0, -1e-300, 1e300}) {
    RangeFit fit;
    fit.Add(std::vector<double>{value, value});
    ASSERT_TRUE(fit.Range());
    EXPECT_EQ(fit.Range()->low, value);
    EXPECT_GT(fit.Range()->high, value);
  }
}

}  // namespace
}  // namespace sph
