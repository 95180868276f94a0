// The axes of a plot: the range they show, their ticks, and where a value lies on them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/plot.hpp"

namespace sph {

/// A mark on an axis; without a label, a minor one.
struct Tick {
  double value = 0;
  std::string label;
};

/// Round numbers in [low, high]: the multiples of the smallest step of 1, 2 or 5 times a power of ten that has at most
/// `at_most` of them there, all labelled with the decimals of that step. Precondition: low < high, at_most >= 1.
std::vector<Tick> LinearTicks(double low, double high, int at_most);

/// The decades in [low, high], or every n-th if there are more than `at_most`, with minor ticks between them: 2, 3, ...
/// 9, or the decades left out. Where fewer than three decades lie, 1, 2, 5 or 1, 3 times powers of ten if there is
/// room; where not even two of these lie, LinearTicks. Precondition: 0 < low < high, at_most >= 1.
std::vector<Tick> LogTicks(double low, double high, int at_most);

/// Can an axis of this scale show the value? Finite, below 1e300, and on a logarithmic axis above 1e-300.
bool Drawable(double value, Scale scale);

/// Smallest and largest drawable value so far.
class Extent {
 public:
  explicit Extent(Scale scale) : scale_(scale) {}
  void Add(double value);
  void Add(std::span<const double> values);
  bool Empty() const { return low_ > high_; }
  double Low() const { return low_; }
  double High() const { return high_; }

 private:
  Scale scale_;
  double low_ = 1;
  double high_ = 0;
};

/// Where a value lies between the pixels of the axis's two ends. With first = 0 and last = 1: its part of the axis.
struct AxisMap {
  Scale scale = Scale::kLinear;
  double low = 0;
  double high = 1;
  double first = 0;  ///< pixel of low
  double last = 1;   ///< pixel of high

  /// Precondition: Drawable(value, scale).
  double ToPixel(double value) const;
  /// The value at a part of the axis: low at 0, high at 1, evenly along the axis between.
  double At(double part) const;
  bool Contains(double value) const { return low <= value && value <= high; }
};

/// The axis's own ends where it has them, else those of the data and 4 % of the axis beyond (`margin` false: nothing
/// beyond), but not across 0. Never empty: a single value gets room around it, no value 0 ... 1 or 1 ... 10.
AxisMap FitAxis(const Axis& axis, const Extent& data, bool margin = true);

/// 10 to the power of `exponent`, as in 10⁻³.
std::string PowerOfTen(int exponent);

}  // namespace sph
