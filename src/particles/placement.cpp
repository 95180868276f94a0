#include "particles/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/check.hpp"

namespace sph {

double Region::Area() const { return radius > 0 ? std::numbers::pi * radius * radius : box.Width() * box.Height(); }

Box Region::Bounds() const {
  if (radius > 0) return {centre.x - radius, centre.y - radius, centre.x + radius, centre.y + radius};
  return box;
}

bool Region::Contains(Vec2 point) const {
  if (radius > 0) return Dot(point - centre, point - centre) <= radius * radius;
  return point.x >= box.x0 && point.x <= box.x1 && point.y >= box.y0 && point.y <= box.y1;
}

double Spacing(const Block& block) {
  if (block.spacing > 0) return block.spacing;
  return block.particles > 0 ? std::sqrt(block.region.Area() / static_cast<double>(block.particles)) : 0.0;
}

namespace {

std::vector<Vec2> PlaceAtRandom(const Block& block, Random& random) {
  const Box bounds = block.region.Bounds();
  std::vector<Vec2> places;
  places.reserve(block.particles);
  while (places.size() < block.particles) {
    const double x = random.Uniform(bounds.x0, bounds.x1);
    const double y = random.Uniform(bounds.y0, bounds.y1);
    if (block.region.Contains({x, y})) places.push_back({x, y});
  }
  return places;
}

/// Rows sqrt(3)/2 apart in units of the distance in a row; a disk has a particle in its centre.
std::vector<Vec2> PlaceHexagonally(const Block& block) {
  const double pitch = Spacing(block) * std::sqrt(2 / std::numbers::sqrt3);
  const double rise = 0.5 * std::numbers::sqrt3 * pitch;
  const Box bounds = block.region.Bounds();
  const bool a_box = block.region.radius <= 0;
  const Vec2 origin = a_box ? Vec2{bounds.x0 + 0.25 * pitch, bounds.y0 + 0.5 * rise} : block.region.centre;
  const auto rows = static_cast<long>(std::ceil(bounds.Height() / rise)) + 1;
  const auto columns = static_cast<long>(std::ceil(bounds.Width() / pitch)) + 1;
  std::vector<Vec2> places;
  for (long row = a_box ? 0 : -rows; row <= rows; ++row) {
    for (long column = a_box ? 0 : -columns; column <= columns; ++column) {
      const double offset = row % 2 == 0 ? 0 : 0.5;
      const Vec2 site = origin + Vec2{(static_cast<double>(column) + offset) * pitch, static_cast<double>(row) * rise};
      if (block.region.Contains(site) && places.size() < block.particles) places.push_back(site);
    }
  }
  return places;
}

/// Calls visit(site) for the sites of a square lattice, half a spacing inside `box`, rows from the bottom up, until it
/// returns false. A box narrower than a spacing has one column in its middle.
template <typename Visit>
void VisitLattice(const Box& box, double spacing, Visit visit) {
  constexpr double kRoundOff = 1e-9;
  constexpr double kMostColumns = 1e9;
  const double width = box.Width() / spacing;
  const auto columns = static_cast<long>(std::clamp(std::floor(width + kRoundOff), 1.0, kMostColumns));
  const double margin = 0.5 * std::min(width + kRoundOff, 1.0);
  for (long row = 0; box.y0 + static_cast<double>(row + 1) * spacing <= box.y1 + kRoundOff * spacing; ++row) {
    for (long column = 0; column < columns; ++column) {
      const Vec2 site{box.x0 + (static_cast<double>(column) + margin) * spacing,
                      box.y0 + (static_cast<double>(row) + 0.5) * spacing};
      if (!visit(site)) return;
    }
  }
}

}  // namespace

std::vector<Vec2> Place(const Block& block, Random& random) {
  SPH_CHECK(block.region.Area() > 0, "area = {}", block.region.Area());
  if (block.particles == 0) return {};
  if (block.arrange == Arrangement::kRandom || block.arrange == Arrangement::kRelaxed)
    return PlaceAtRandom(block, random);
  if (block.arrange == Arrangement::kHexagonal) return PlaceHexagonally(block);
  std::vector<Vec2> places;
  Box column = block.region.Bounds();
  const bool a_box = block.region.radius <= 0;
  if (a_box) column.y1 = std::numeric_limits<double>::max();
  VisitLattice(column, Spacing(block), [&](Vec2 site) {
    if (!a_box && !block.region.Contains(site)) return true;
    if (block.arrange == Arrangement::kJittered) site.x += block.jitter * random.Uniform();
    if (block.arrange == Arrangement::kPerturbed) {
      site.x += random.Uniform(-block.jitter, block.jitter);
      site.y += random.Uniform(-block.jitter, block.jitter);
    }
    places.push_back(site);
    return places.size() < block.particles;
  });
  return places;
}

std::vector<Vec2> PlaceAround(const Block& block, const Box& room, const std::function<bool(Vec2)>& occupied) {
  constexpr double kMostColumns = 1000;
  const Box start = block.region.Bounds();
  const auto most_columns = static_cast<int>(std::min(room.Width() / start.Width(), kMostColumns)) + 1;
  std::size_t tries = 10'000 + 100 * block.particles;  // of sites; a lattice may be too fine to be filled
  for (int k = 0; k <= 2 * most_columns && tries > 0; ++k) {
    const int columns_away = (k + 1) / 2;
    const double shift = start.Width() * (k % 2 == 1 ? columns_away : -columns_away);
    const Box column{start.x0 + shift, start.y0, start.x1 + shift, room.y1};
    if (k > 0 && (column.x0 < room.x0 || column.x1 > room.x1)) continue;
    std::vector<Vec2> places;
    VisitLattice(column, Spacing(block), [&](Vec2 site) {
      if (!occupied(site)) places.push_back(site);
      return places.size() < block.particles && --tries > 0;
    });
    if (places.size() == block.particles) return places;
  }
  return {};
}

}  // namespace sph
