// Series of points (x, y) with rising x, as measured or computed: values between the points, and how two of them
// differ.
#pragma once

#include <vector>

#include "base/vec2.hpp"

namespace sph {

using PointSeries = std::vector<Vec2>;

/// Linear between the points, and constant beyond the ends. Precondition: not empty.
double ValueAt(const PointSeries& series, double x);

/// The first x at which the series passes a level upwards; infinite if it never does.
double FirstAbove(const PointSeries& series, double level);

/// Root mean square of computed(x - delay) - measured(x) over the points of `measured`.
double Difference(const PointSeries& computed, const PointSeries& measured, double delay = 0);

/// The delay from 0 to `longest` with the least such difference, to a thousandth of `longest`.
double BestDelay(const PointSeries& computed, const PointSeries& measured, double longest);

}  // namespace sph
