#include "particles/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.hpp"
#include "particles/lattice.hpp"

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

}  // namespace

std::vector<Vec2> Place(const Block& block, Random& random) {
  SPH_CHECK(block.region.Area() > 0, "area = {}", block.region.Area());
  if (block.particles == 0) return {};
  if (!block.IsLattice()) return PlaceAtRandom(block, random);
  std::vector<Vec2> places;
  VisitSites(block, [&](Vec2 site) {
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
