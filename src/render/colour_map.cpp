#include "render/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sph {
namespace {

constexpr int kSteps = 255;

/// The sRGB transfer function [IEC 61966-2-1], of linear light in 0..1, to 8 bits.
std::uint8_t Encoded(double light) {
  const double c = std::clamp(light, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

/// From Oklab to linear light of the screen's primaries, with Ottosson's matrices.
Rgb FromOklab(double L, double a, double b) {
  const auto cubed = [](double root) { return root * root * root; };
  const double l = cubed(L + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cubed(L - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cubed(L - 0.0894841775 * a - 1.2914855480 * b);
  return {Encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          Encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          Encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Rgb OnThePath(double t) {
  const double lightness = 0.27 + 0.63 * t;
  const double hue = (300 - 195 * t) * std::numbers::pi / 180;
  const double u = 2 * t - 1;
  const double chroma = 0.09 + 0.035 * u * u + 0.015 * u * u * u;
  return FromOklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

std::array<Rgb, kSteps + 1> Table() {
  std::array<Rgb, kSteps + 1> table;
  for (int i = 0; i <= kSteps; ++i) table[i] = OnThePath(static_cast<double>(i) / kSteps);
  return table;
}

}  // namespace

Rgb ColourAt(double t) {
  static const std::array<Rgb, kSteps + 1> table = Table();
  return table[static_cast<std::size_t>(std::lround(kSteps * std::clamp(t, 0.0, 1.0)))];
}

}  // namespace sph
