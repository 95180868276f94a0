// A picture in memory: what a frame is read into and a PNG file is written from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sph {

/// 8-bit red, green, blue; rgb has 3 * width * height bytes, rows from top to bottom, no padding.
struct Image {
  int width = 0;   // [pixels]
  int height = 0;  // [pixels]
  std::vector<std::uint8_t> rgb;

  /// The three bytes of the pixel in column x from the left and row y from the top.
  const std::uint8_t* Pixel(int x, int y) const {
    return rgb.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace sph
