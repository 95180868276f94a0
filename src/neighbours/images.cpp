#include "neighbours/images.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace sph {

Vec2 Periods::Wrap(Vec2 point) const {
  if (in_x) point.x -= box.Width() * std::floor((point.x - box.x0) / box.Width());
  if (in_y) point.y -= box.Height() * std::floor((point.y - box.y0) / box.Height());
  return point;
}

void Images::Find(const Periods& periods, double reach, std::span<const double> x, std::span<const double> y) {
  sources_.clear();
  shift_x_.clear();
  shift_y_.clear();
  if (!periods.Any()) return;
  const Box& box = periods.box;
  SPH_CHECK((!periods.in_x || box.Width() > 2 * reach) && (!periods.in_y || box.Height() > 2 * reach),
            "a period of {} m x {} m is too short for a reach of {} m", box.Width(), box.Height(), reach);
  const auto add = [&](std::size_t i, double shift_x, double shift_y) {
    sources_.push_back(static_cast<std::uint32_t>(i));
    shift_x_.push_back(shift_x);
    shift_y_.push_back(shift_y);
  };
  double drift = 0;  // [m], of the particle furthest out
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (periods.in_x) drift = std::max({drift, box.x0 - x[i], x[i] - box.x1});
    if (periods.in_y) drift = std::max({drift, box.y0 - y[i], y[i] - box.y1});
  }
  const double margin = reach + drift;
  /// By how much a coordinate's image is shifted; 0 if there is none.
  const auto shift = [margin](bool periodic, double at, double low, double high) {
    if (periodic && at < low + margin) return high - low;
    if (periodic && at > high - margin) return low - high;
    return 0.0;
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double shift_x = shift(periods.in_x, x[i], box.x0, box.x1);
    const double shift_y = shift(periods.in_y, y[i], box.y0, box.y1);
    if (shift_x != 0) add(i, shift_x, 0);
    if (shift_y != 0) add(i, 0, shift_y);
    if (shift_x != 0 && shift_y != 0) add(i, shift_x, shift_y);
  }
}

void Images::Reorder(std::span<const std::uint32_t> order) {
  const auto apply = [&](auto& values, auto& scratch) {
    scratch.resize(values.size());
    for (std::size_t k = 0; k < order.size(); ++k) scratch[k] = values[order[k]];
    values.swap(scratch);
  };
  apply(sources_, sources_scratch_);
  apply(shift_x_, scratch_);
  apply(shift_y_, scratch_);
}

std::size_t Images::Bytes() const {
  return sizeof(std::uint32_t) * (sources_.capacity() + sources_scratch_.capacity()) +
         sizeof(double) * (shift_x_.capacity() + shift_y_.capacity() + scratch_.capacity());
}

}  // namespace sph
