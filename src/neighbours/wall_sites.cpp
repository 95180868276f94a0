#include "neighbours/wall_sites.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

constexpr double kMostSites = 1e9;  // from the origin

/// One axis of the lattice: site k is at origin + (k + 1/2) step. What is beyond a high wall begins with site `count`.
struct SiteAxis {
  AxisEnds ends;
  std::int32_t count = 0;  // between two ends; 0 where there are not two
  double origin = 0;       // [m]
  double step = 0;         // [m]

  SiteAxis(const AxisEnds& of, double spacing, std::int32_t sites) : ends(of), count(sites), step(spacing) {
    const bool low = std::isfinite(ends.low), high = std::isfinite(ends.high);
    origin = low ? ends.low : high ? ends.high : 0;
    if (count > 0) step = std::max((ends.high - ends.low) / count, 0.5 * spacing);  // walls may meet
  }

  bool Walled(Beyond side) const {
    return !ends.periodic && std::isfinite(side == Beyond::kLow ? ends.low : ends.high);
  }
  double At(std::int32_t site) const { return origin + (site + 0.5) * step; }
  bool Near(Beyond side, double at, double reach) const {
    return side == Beyond::kLow ? at < ends.low + reach : at > ends.high - reach;
  }
};

std::int32_t SitesBetween(const AxisEnds& ends, double spacing) {
  const double length = ends.high - ends.low;
  return std::isfinite(length) ? static_cast<std::int32_t>(std::clamp(std::round(length / spacing), 1.0, kMostSites))
                               : 0;
}

using Range = std::pair<std::int32_t, std::int32_t>;  // first ... second - 1

/// The layers beyond a wall.
Range Layers(const SiteAxis& axis, Beyond side, std::int32_t layers) {
  return side == Beyond::kLow ? Range{-layers, 0} : Range{axis.count, axis.count + layers};
}

/// The sites along a wall, at most `margin` from those of `near`, but for what is beyond other walls.
std::vector<Range> Along(const SiteAxis& axis, std::vector<std::int32_t>& near, std::int32_t margin) {
  std::ranges::sort(near);
  std::vector<Range> ranges;
  for (const std::int32_t site : near) {
    Range range{site - margin, site + margin + 1};
    if (axis.Walled(Beyond::kLow)) range.first = std::max(range.first, 0);
    if (axis.Walled(Beyond::kHigh)) range.second = std::min(range.second, axis.count);
    if (range.first >= range.second) continue;
    if (!ranges.empty() && range.first <= ranges.back().second) {
      ranges.back().second = std::max(ranges.back().second, range.second);
    } else {
      ranges.push_back(range);
    }
  }
  return ranges;
}

}  // namespace

void WallSites::Find(const Ends& ends, double reach, std::span<const double> x, std::span<const double> y) {
  sites_.clear();
  const double spacing = ends.site_spacing;
  if (spacing <= 0) return;
  columns_ = SitesBetween(ends.x, spacing);
  rows_ = SitesBetween(ends.y, spacing);
  const SiteAxis axis_x(ends.x, spacing, columns_), axis_y(ends.y, spacing, rows_);
  const auto layers_of = [&](const SiteAxis& axis) { return static_cast<std::int32_t>(std::ceil(reach / axis.step)); };
  const std::int32_t layers_x = layers_of(axis_x), layers_y = layers_of(axis_y);
  const auto add = [&](Range columns, Range rows, Beyond in_x, Beyond in_y) {
    for (std::int32_t column = columns.first; column < columns.second; ++column) {
      for (std::int32_t row = rows.first; row < rows.second; ++row) sites_.push_back({column, row, in_x, in_y});
    }
  };
  std::vector<std::int32_t> near;
  const auto find_near = [&](const SiteAxis& across, std::span<const double> depth, Beyond side, const SiteAxis& along,
                             std::span<const double> places) {
    near.clear();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double site = std::floor((places[i] - along.origin) / along.step);
      if (across.Near(side, depth[i], reach) && std::abs(site) < kMostSites) {
        near.push_back(static_cast<std::int32_t>(site));
      }
    }
  };
  for (const Beyond side : {Beyond::kLow, Beyond::kHigh}) {
    if (axis_x.Walled(side)) {
      find_near(axis_x, x, side, axis_y, y);
      for (const Range& rows : Along(axis_y, near, layers_y)) {
        add(Layers(axis_x, side, layers_x), rows, side, Beyond::kNone);
      }
    }
    if (axis_y.Walled(side)) {
      find_near(axis_y, y, side, axis_x, x);
      for (const Range& columns : Along(axis_x, near, layers_x)) {
        add(columns, Layers(axis_y, side, layers_y), Beyond::kNone, side);
      }
    }
  }
  for (const Beyond side_x : {Beyond::kLow, Beyond::kHigh}) {
    for (const Beyond side_y : {Beyond::kLow, Beyond::kHigh}) {
      if (!axis_x.Walled(side_x) || !axis_y.Walled(side_y)) continue;
      bool fluid = false;
      for (std::size_t i = 0; i < x.size() && !fluid; ++i) {
        fluid = axis_x.Near(side_x, x[i], reach) && axis_y.Near(side_y, y[i], reach);
      }
      if (fluid) add(Layers(axis_x, side_x, layers_x), Layers(axis_y, side_y, layers_y), side_x, side_y);
    }
  }
}

void WallSites::Reorder(std::span<const std::uint32_t> order) {
  scratch_.resize(sites_.size());
  for (std::size_t k = 0; k < order.size(); ++k) scratch_[k] = sites_[order[k]];
  sites_.swap(scratch_);
}

void WallSites::Place(const Ends& ends, std::vector<double>& x, std::vector<double>& y) const {
  const SiteAxis axis_x(ends.x, ends.site_spacing, columns_), axis_y(ends.y, ends.site_spacing, rows_);
  for (const WallSite& site : sites_) {
    x.push_back(axis_x.At(site.column));
    y.push_back(axis_y.At(site.row));
  }
}

void WallSites::Transfer(Archive& archive) {
  std::vector<std::int32_t> numbers;
  std::vector<Beyond> sides;
  for (const WallSite& site : sites_) {
    numbers.insert(numbers.end(), {site.column, site.row});
    sides.insert(sides.end(), {site.in_x, site.in_y});
  }
  archive(columns_, rows_, numbers, sides);
  if (!archive.Reading()) return;
  Archive::Require(columns_ >= 0 && rows_ >= 0 && numbers.size() == sides.size() && numbers.size() % 2 == 0);
  sites_.clear();
  for (std::size_t k = 0; k < numbers.size(); k += 2) {
    Archive::Require(sides[k] <= Beyond::kHigh && sides[k + 1] <= Beyond::kHigh);
    sites_.push_back({numbers[k], numbers[k + 1], sides[k], sides[k + 1]});
  }
}

std::size_t WallSites::Bytes() const { return sizeof(WallSite) * (sites_.capacity() + scratch_.capacity()); }

}  // namespace sph
