// What can be measured of a picture in black on white.
#pragma once

#include <vector>

#include "io/image.hpp"

namespace sph {

/// Mean darkness, 0 white to 1 black, of each block of kBlock x kBlock pixels, rows from the top. What is left over at
/// the right and lower edge is left out.
constexpr int kBlock = 8;
std::vector<double> BlockDarkness(const Image& image);

/// The largest difference of two pictures in the darkness of any block; infinite if their sizes differ.
double LargestBlockDifference(const Image& a, const Image& b);

/// How many black pixels the ink in columns first ... last - 1 would fill.
double InkBetween(const Image& image, int first, int last);

/// The vertical walls: the middles of the stripes of columns that are black over at least `height` pixels [pixels].
std::vector<double> VerticalLines(const Image& image, int height);

}  // namespace sph
