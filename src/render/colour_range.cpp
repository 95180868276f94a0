#include "render/colour_range.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

void RangeFit::Add(std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value);
  }
}

std::optional<ColourRange> RangeFit::Range() const {
  if (least_ > greatest_) return std::nullopt;
  const double resolved = 1e-9 * std::max(std::abs(least_), std::abs(greatest_));
  if (greatest_ - least_ > resolved) return ColourRange{least_, greatest_};
  return ColourRange{least_, least_ + std::max(1.0, 2 * resolved)};
}

}  // namespace sph
