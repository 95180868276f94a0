#include "sph/clouds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/random.hpp"

namespace sph {
namespace {

using PlaceOf = std::function<Vec2(std::size_t k, std::size_t n, Random&)>;

Vec2 OnALattice(std::size_t k, std::size_t n, Random&) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  constexpr double kSpacing = 0.8 * kCloudH;
  return {kSpacing * static_cast<double>(k % columns), kSpacing * static_cast<double>(k / columns)};
}

Vec2 AtRandom(std::size_t, std::size_t n, Random& random) {
  const double side = kCloudH * std::sqrt(static_cast<double>(n));
  return {random.Uniform(-side, side), random.Uniform(0, side)};
}

Vec2 InClumps(std::size_t k, std::size_t, Random& random) {
  const Vec2 centre{0.7 * static_cast<double>(k % 3), k % 7 == 0 ? 2.0 : 0.0};
  const double radius = kCloudH * std::pow(random.Uniform(), 3);
  return centre + Vec2{random.Uniform(-radius, radius), random.Uniform(-radius, radius)};
}

Vec2 InPairsOfCoincident(std::size_t k, std::size_t, Random&) {
  return {0.6 * kCloudH * static_cast<double>(k / 2 % 11), 0.7 * kCloudH * static_cast<double>(k / 22)};
}

Vec2 AllInOnePlace(std::size_t, std::size_t, Random&) { return {0.3, -0.4}; }

Vec2 WithEscaped(std::size_t k, std::size_t n, Random& random) {
  const Vec2 near = AtRandom(k, n, random);
  return k % 8 == 7 ? Vec2{1e7 * near.x, -1e6} : near;
}

Cloud Make(const std::string& name, std::size_t n, const PlaceOf& place) {
  Random random(n + 1);
  Cloud cloud;
  cloud.name = name + ", " + std::to_string(n) + " particles";
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 at = place(k, n, random);
    cloud.x.push_back(at.x);
    cloud.y.push_back(at.y);
    cloud.vx.push_back(random.Uniform(-1, 1));
    cloud.vy.push_back(random.Uniform(-1, 1));
    cloud.mass.push_back(random.Uniform(0.5, 1.5) * kCloudH * kCloudH);
  }
  return cloud;
}

}  // namespace

std::vector<Cloud> AllClouds() {
  std::vector<Cloud> clouds;
  for (const std::size_t n : {0, 1, 2, 15, 16, 17, 257, 600}) {
    clouds.push_back(Make("lattice", n, OnALattice));
    clouds.push_back(Make("random", n, AtRandom));
    clouds.push_back(Make("clumps", n, InClumps));
    clouds.push_back(Make("coincident pairs", n, InPairsOfCoincident));
    clouds.push_back(Make("one place", n, AllInOnePlace));
    clouds.push_back(Make("some escaped", n, WithEscaped));
  }
  return clouds;
}

Neighbourhood FindNeighbours(const Cloud& cloud, double reach) {
  CellGrid grid;
  grid.Build(cloud.x, cloud.y, reach);
  Neighbourhood found;
  found.cloud.name = cloud.name;
  for (auto component : {&Cloud::x, &Cloud::y, &Cloud::vx, &Cloud::vy, &Cloud::mass}) {
    for (const std::uint32_t i : grid.Order()) (found.cloud.*component).push_back((cloud.*component)[i]);
  }
  for (std::size_t first = 0; first < cloud.Size(); first += kParticlesPerBlock) {
    const std::size_t count = std::min(kParticlesPerBlock, cloud.Size() - first);
    found.blocks.emplace_back().Find(grid, found.cloud.x, found.cloud.y, reach, first, count);
  }
  return found;
}

}  // namespace sph
