// Which values the two ends of the colour map stand for.
#pragma once

#include <limits>
#include <optional>
#include <span>

namespace sph {

/// The values [SI unit of the quantity] at the two ends of the colour map; low < high, both finite.
struct ColourRange {
  double low = 0;
  double high = 1;
  friend bool operator==(const ColourRange&, const ColourRange&) = default;
};

/// From the least to the greatest finite value added; one unit (or what the number's digits can tell apart) wide if
/// they are the same; none if there is none.
class RangeFit {
 public:
  void Add(std::span<const double> values);
  std::optional<ColourRange> Range() const;

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double greatest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace sph
