// The words of the legend: what the colours show, in which unit, from which value to which.
#pragma once

#include <string>

#include "particles/canvas.hpp"
#include "render/colour_range.hpp"

namespace sph {

/// What the legend says: quantity and unit, and the values at the two ends of the colour bar.
struct LegendText {
  std::string title;
  std::string low;
  std::string high;
};

/// "speed [m/s]". SPH_CHECK: not for black disks, which show no quantity.
std::string QuantityTitle(Colouring colouring);

/// Title and end values, written with as many digits as tell a hundredth of the range.
LegendText LegendOf(Colouring colouring, const ColourRange& range);

}  // namespace sph
