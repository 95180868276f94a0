#include "commands/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sph {
namespace {

double Darkness(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.Pixel(x, y);
  return (3 * 255 - pixel[0] - pixel[1] - pixel[2]) / (3 * 255.0);
}

}  // namespace

std::vector<double> BlockDarkness(const Image& image) {
  std::vector<double> blocks;
  for (int top = 0; top + kBlock <= image.height; top += kBlock) {
    for (int left = 0; left + kBlock <= image.width; left += kBlock) {
      double sum = 0;
      for (int i = 0; i < kBlock * kBlock; ++i) sum += Darkness(image, left + i % kBlock, top + i / kBlock);
      blocks.push_back(sum / (kBlock * kBlock));
    }
  }
  return blocks;
}

double LargestBlockDifference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return std::numeric_limits<double>::infinity();
  const std::vector<double> in_a = BlockDarkness(a), in_b = BlockDarkness(b);
  double largest = 0;
  for (std::size_t i = 0; i < in_a.size(); ++i) largest = std::max(largest, std::abs(in_a[i] - in_b[i]));
  return largest;
}

double InkBetween(const Image& image, int first, int last) {
  double ink = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = std::max(first, 0); x < std::min(last, image.width); ++x) ink += Darkness(image, x, y);
  }
  return ink;
}

std::vector<double> VerticalLines(const Image& image, int height) {
  std::vector<double> lines;
  int first = -1;  // column of the stripe that is being read
  for (int x = 0; x <= image.width; ++x) {
    const bool black = x < image.width && InkBetween(image, x, x + 1) >= height;
    if (black && first < 0) first = x;
    if (!black && first >= 0) lines.push_back(0.5 * (first + x));
    if (!black) first = -1;
  }
  return lines;
}

}  // namespace sph
