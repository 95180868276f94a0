// Looking at a drawn plot pixel by pixel.
#pragma once

#include <algorithm>
#include <cmath>

#include "lab/plot.hpp"

namespace sph {

constexpr Colour kRed = {1, 0, 0};

/// The pixel of a point of the picture.
inline Colour PixelAt(const Image& image, double x, double y) {
  const std::uint8_t* p = image.Pixel(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
  return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
}

/// The largest difference of the three channels.
inline double Distance(Colour a, Colour b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

/// Number of pixels of the box that are of that colour, up to `tolerance` in each channel.
inline int CountOfColour(const Image& image, const Box& box, Colour colour, double tolerance = 0.25) {
  int count = 0;
  for (int y = std::max(0, static_cast<int>(box.y0)); y < std::min<double>(image.height, box.y1); ++y) {
    for (int x = std::max(0, static_cast<int>(box.x0)); x < std::min<double>(image.width, box.x1); ++x) {
      count += Distance(PixelAt(image, x, y), colour) <= tolerance ? 1 : 0;
    }
  }
  return count;
}

/// Number of pixels of the box that are not white; the box has corners of whole pixels.
inline int CountInk(const Image& image, const Box& box) {
  return static_cast<int>(box.Width() * box.Height()) - CountOfColour(image, box, {1, 1, 1}, 0);
}

inline Box WholeOf(const Image& image) { return {0, 0, 1.0 * image.width, 1.0 * image.height}; }

/// The smallest box around the pixels that differ between two pictures of one size; empty if there are none.
inline Box DifferenceOf(const Image& a, const Image& b) {
  Box box = {1e9, 1e9, 0, 0};
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (std::equal(a.Pixel(x, y), a.Pixel(x, y) + 3, b.Pixel(x, y))) continue;
      box = {std::min<double>(box.x0, x), std::min<double>(box.y0, y), std::max<double>(box.x1, x + 1),
             std::max<double>(box.y1, y + 1)};
    }
  }
  return box.x1 > 0 ? box : Box{};
}

/// A plot of the unit square with one red series.
inline Plot UnitSquare(Series series) {
  series.colour = kRed;
  Plot plot;
  plot.x.low = plot.y.low = 0;
  plot.x.high = plot.y.high = 1;
  plot.series = {std::move(series)};
  return plot;
}

}  // namespace sph
