#include "particles/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph {

Vec2 PitchOf(const Block& block) {
  const double spacing = Spacing(block);
  if (block.arrange != Arrangement::kHexagonal) return {spacing, spacing};
  const double pitch = spacing * std::sqrt(2 / std::numbers::sqrt3);
  return {pitch, 0.5 * std::numbers::sqrt3 * pitch};
}

namespace {

/// A side's part of so many cells; where they are not stretched but for rounding, the pitch itself.
double Stretched(double side, std::size_t cells, double pitch) {
  constexpr double kRoundOff = 1e-9;
  const double stretched = side / static_cast<double>(cells);
  return std::abs(stretched - pitch) <= kRoundOff * pitch ? pitch : stretched;
}

}  // namespace

Lattice LatticeInside(const Block& block) {
  const bool hexagonal = block.arrange == Arrangement::kHexagonal;
  Vec2 pitch = PitchOf(block);
  if (block.IsDisk()) return {block.region.centre, pitch, {0, 0}, hexagonal};
  const Box& box = block.region.box;
  if (block.columns > 0) {
    pitch = {Stretched(box.Width(), block.columns, pitch.x), Stretched(box.Height(), block.rows, pitch.y)};
  }
  return {{box.x0, box.y0}, pitch, {hexagonal ? 0.25 : 0.5, 0.5}, hexagonal};
}

Run RowsInside(const Block& block, const Lattice& lattice) {
  if (block.rows > 0) return {0, static_cast<long>(block.rows) - 1};
  const auto rows = static_cast<long>(std::ceil(block.region.Bounds().Height() / lattice.pitch.y)) + 1;
  return {block.IsDisk() ? -rows : 0, rows};
}

Run ColumnsInside(const Block& block, const Lattice& lattice, long row) {
  if (block.columns > 0) return {0, static_cast<long>(block.columns) - 1};
  const Region& region = block.region;
  const Vec2 start = lattice.Site(0, row);
  Vec2 chord{region.box.x0, region.box.x1};
  if (block.IsDisk()) {
    const double height = start.y - region.centre.y;
    const double half = std::sqrt(std::max(0.0, region.radius * region.radius - height * height));
    chord = {region.centre.x - half, region.centre.x + half};
  } else if (start.y > region.box.y1) {
    return {};
  }
  Run columns{static_cast<long>(std::ceil((chord.x - start.x) / lattice.pitch.x)),
              static_cast<long>(std::floor((chord.y - start.x) / lattice.pitch.x))};
  const auto inside = [&](long column) { return region.Contains(lattice.Site(column, row)); };
  columns.first += inside(columns.first - 1) ? -1 : inside(columns.first) ? 0 : 1;  // rounding
  columns.last += inside(columns.last + 1) ? 1 : inside(columns.last) ? 0 : -1;
  return columns;
}

std::size_t SitesInside(const Block& block) {
  const Lattice lattice = LatticeInside(block);
  const Run rows = RowsInside(block, lattice);
  std::size_t sites = 0;
  for (long row = rows.first; row <= rows.last; ++row) {
    const Run columns = ColumnsInside(block, lattice, row);
    sites += static_cast<std::size_t>(std::max(0L, columns.last - columns.first + 1));
  }
  return sites;
}

Columns ColumnsOf(const Box& box, double spacing) {
  constexpr double kMostColumns = 1e9;
  const double furthest = std::max({std::abs(box.x0), std::abs(box.x1), std::abs(box.y0)});
  const double round_off = 1e-9 + 4 * std::numeric_limits<double>::epsilon() * furthest / spacing;
  const double width = box.Width() / spacing + round_off;
  return {static_cast<long>(std::clamp(std::floor(width), 1.0, kMostColumns)), 0.5 * std::min(width, 1.0)};
}

bool StartsAtTheBottom(const Block& block) {
  if (block.arrange == Arrangement::kHexagonal || block.columns > 0) return false;
  return !block.IsDisk() || block.spacing > 0;
}

}  // namespace sph
