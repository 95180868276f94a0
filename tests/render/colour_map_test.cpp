#include "render/colour_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace sph {
namespace {

constexpr int kSteps = 255;

/// Linear light of the three primaries [IEC 61966-2-1].
std::array<double, 3> Light(Rgb colour) {
  std::array<double, 3> light = {};
  const std::array<std::uint8_t, 3> bytes = {colour.red, colour.green, colour.blue};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = bytes[i] / 255.0;
    light[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return light;
}

struct Lab {
  double lightness, a, b;
};

/// CIE L*a*b*, D65: another space than the one the map was made in.
Lab ToLab(const std::array<double, 3>& rgb) {
  const auto [r, g, b] = rgb;
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double Distance(const Lab& p, const Lab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

/// What a deuteranope sees of it, in linear light [Vienot, Brettel & Mollon 1999, Color Res. Appl. 24, 243].
std::array<double, 3> SeenByADeuteranope(const std::array<double, 3>& rgb) {
  const auto [r, g, b] = rgb;
  const double yellow = 0.29275 * r + 0.70725 * g;
  return {yellow, yellow, -0.02234 * r + 0.02234 * g + b};
}

// In steps that 8 bits resolve.
TEST(ColourMap, GrowsLighterWithTheValue) {
  for (int i = 0; i < 64; ++i) {
    const double lower = ToLab(Light(ColourAt(i / 64.0))).lightness;
    const double higher = ToLab(Light(ColourAt((i + 1) / 64.0))).lightness;
    EXPECT_GT(higher, lower + 0.5) << i;
  }
}

TEST(ColourMap, ChangesEquallyFastEverywhere) {
  std::vector<Lab> path;
  for (int i = 0; i <= 15; ++i) path.push_back(ToLab(Light(ColourAt(i / 15.0))));
  double shortest = 1e9;
  double longest = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    shortest = std::min(shortest, Distance(path[i - 1], path[i]));
    longest = std::max(longest, Distance(path[i - 1], path[i]));
  }
  // Measured in L*a*b*, which is itself uniform to a factor of about two.
  EXPECT_LT(longest, 2 * shortest);
}

TEST(ColourMap, TellsValuesApartForEyesThatConfuseRedAndGreen) {
  for (int i = 0; i <= 10; ++i) {
    for (int j = i + 1; j <= 10; ++j) {
      const Lab p = ToLab(SeenByADeuteranope(Light(ColourAt(i / 10.0))));
      const Lab q = ToLab(SeenByADeuteranope(Light(ColourAt(j / 10.0))));
      EXPECT_GT(Distance(p, q), 5 * (j - i)) << i << " " << j;  // 2.3 is just noticeable
    }
  }
}

TEST(ColourMap, StaysVisibleOnWhiteAndApartFromTheColourOfNotANumber) {
  const Lab white = ToLab({1, 1, 1});
  const Lab no_number = ToLab(Light(kNotANumberColour));
  for (int i = 0; i <= kSteps; ++i) {
    const Lab colour = ToLab(Light(ColourAt(static_cast<double>(i) / kSteps)));
    EXPECT_GT(Distance(colour, white), 40) << i;
    EXPECT_GT(Distance(colour, no_number), 40) << i;
  }
}

TEST(ColourMap, HasTheEndsColoursBeyondItsEnds) {
  EXPECT_EQ(ColourAt(-5), ColourAt(0));
  EXPECT_EQ(ColourAt(1e300), ColourAt(1));
}

}  // namespace
}  // namespace sph
