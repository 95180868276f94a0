// Colours for values: lightness grows with the value, in equal steps to the eye, so that it reads in grey print and by
// eyes that tell red and green apart badly.
#pragma once

#include <cstdint>

namespace sph {

/// 8 bits each, as the screen shows them (sRGB).
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// The colour of t: from dark violet at 0 by blue and green to yellow at 1; the ends' colours beyond them.
/// A path of our own through the Oklab space, whose distances are those that the eye sees [B. Ottosson, A perceptual
/// color space for image processing, 2020, https://bottosson.github.io/posts/oklab/]: lightness L = 0.27 + 0.63 t, hue
/// 300 - 195 t degrees, chroma as large as the screen's colours allow on that path, smooth in t.
Rgb ColourAt(double t);

/// For a value that is not a number: a red that the path does not come near.
constexpr Rgb kNotANumberColour = {230, 0, 30};

}  // namespace sph
