// Blocks whose lattice fills their region: how many particles, how stretched.
#include <algorithm>
#include <cmath>
#include <limits>

#include "particles/lattice.hpp"

namespace sph {
namespace {

Block WithNumber(Block block, std::size_t particles) {
  block.particles = particles;
  return block;
}

/// Whether a disk holds so many at equal parts of its area.
bool FillsDisk(const Block& block, std::size_t particles) {
  return particles > 0 && SitesInside(WithNumber(block, particles)) == particles;
}

Block FittedToDisk(const Block& block) {
  if (block.spacing > 0) {
    std::size_t sites = 0;
    VisitSites(block, [&](Vec2) { return ++sites < block.particles; });
    return WithNumber(block, sites);
  }
  for (std::size_t off = 0; off < block.particles; ++off) {  // one particle in the centre always fits
    for (const std::size_t n : {block.particles - off, block.particles + off}) {
      if (FillsDisk(block, n)) return WithNumber(block, n);
    }
  }
  return block;
}

Block FittedToBox(Block block) {
  const Box& box = block.region.box;
  const Vec2 pitch = PitchOf(block);
  const auto asked = static_cast<double>(block.particles);
  const Vec2 even{std::clamp(box.Width() / pitch.x, 1.0, asked), std::clamp(box.Height() / pitch.y, 1.0, asked)};
  Vec2 best{1, asked};
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](double columns, double rows) {
    const double stretch = std::log(box.Width() / columns / pitch.x) - std::log(box.Height() / rows / pitch.y);
    const double off = std::abs(std::log(columns * rows / asked)) + stretch * stretch;
    if (!(off < least)) return;
    least = off;
    best = {columns, rows};
  };
  for (const double columns : {std::floor(even.x), std::ceil(even.x)}) consider(columns, std::round(asked / columns));
  for (const double rows : {std::floor(even.y), std::ceil(even.y)}) consider(std::round(asked / rows), rows);
  block.columns = static_cast<std::size_t>(best.x);
  block.rows = static_cast<std::size_t>(best.y);
  return WithNumber(block, block.columns * block.rows);
}

}  // namespace

Block Fitted(const Block& block) {
  if (!block.IsLattice() || block.columns > 0 || block.particles == 0) return block;
  if (block.IsDisk()) return FittedToDisk(block);
  if (block.spacing <= 0) return FittedToBox(block);
  const bool ends = block.arrange == Arrangement::kHexagonal;
  return ends ? WithNumber(block, std::min(block.particles, SitesInside(block))) : block;
}

std::pair<std::size_t, std::size_t> FillingNumbers(const Block& block) {
  const std::size_t asked = block.particles;
  std::size_t below = 0, above = 0;
  if (block.IsDisk()) {
    for (std::size_t n = asked - 1; below == 0 && 2 * n > asked; --n) below = FillsDisk(block, n) ? n : 0;
    for (std::size_t n = asked + 1; above == 0 && n < 2 * asked; ++n) above = FillsDisk(block, n) ? n : 0;
    return {below, above};
  }
  constexpr double kRoundOff = 1e-6;
  const Vec2 pitch = PitchOf(block);
  const Box& box = block.region.box;
  const double rows_per_column = box.Height() / box.Width() * pitch.x / pitch.y;
  const double most = 2 * static_cast<double>(asked);
  for (double columns = 1; columns <= most && columns * columns * rows_per_column < most; ++columns) {
    const double rows = std::round(columns * rows_per_column);
    if (std::abs(rows - columns * rows_per_column) > kRoundOff * rows) continue;
    const auto n = static_cast<std::size_t>(columns * rows);
    if (n < asked && 2 * n > asked) below = n;
    if (n > asked && above == 0) above = n;
  }
  return {below, above};
}

Box StartBounds(const Block& block) {
  Box extent = block.region.Bounds();
  if (!block.IsLattice()) return extent;
  if (StartsAtTheBottom(block) && !block.IsDisk()) {
    const double spacing = Spacing(block);
    const auto [columns, margin] = ColumnsOf(extent, spacing);
    const double rows = std::ceil(static_cast<double>(block.particles) / static_cast<double>(columns));
    extent = {extent.x0 + margin * spacing, extent.y0 + 0.5 * spacing,
              extent.x0 + (static_cast<double>(columns - 1) + margin) * spacing, extent.y0 + (rows - 0.5) * spacing};
  } else if (block.columns > 0) {
    const Lattice lattice = LatticeInside(block);
    const Vec2 inside{lattice.margin.x * lattice.pitch.x, lattice.margin.y * lattice.pitch.y};
    extent = {extent.x0 + inside.x, extent.y0 + inside.y, extent.x1 - inside.x, extent.y1 - inside.y};
  }
  const bool perturbed = block.arrange == Arrangement::kPerturbed;
  if (perturbed || block.arrange == Arrangement::kJittered) extent.x1 += block.jitter;
  if (!perturbed) return extent;
  return {extent.x0 - block.jitter, extent.y0 - block.jitter, extent.x1, extent.y1 + block.jitter};
}

}  // namespace sph
