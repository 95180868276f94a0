#include "sph/clouds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/instruction_set.hpp"
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

template <typename Real>
Neighbourhood<Real> FindNeighbours(const Cloud& cloud, double support) {
  Neighbourhood<Real> found;
  found.support = support;
  found.cloud.name = cloud.name;
  found.search.NextTask(0, support);
  found.search.Sort(cloud.x, cloud.y, 0.8 * kCloudH, Lanes<Real>());
  for (auto component : {&Cloud::x, &Cloud::y, &Cloud::vx, &Cloud::vy, &Cloud::mass}) {
    for (const std::uint32_t i : found.search.Order()) (found.cloud.*component).push_back((cloud.*component)[i]);
  }
  const Cloud& sorted = found.cloud;
  found.search.Cut(sorted.x, sorted.y);
  found.positions.Resize(sorted.Size());
  found.positions.Set(sorted.x, sorted.y, support, 0, sorted.Size());
  found.search.Prepare({sorted.x, sorted.y, sorted.vx, sorted.vy, sorted.vx, sorted.vy, 0, 1e-3});
  for (ListBlock& block : found.search.Blocks()) {
    FindNeighbours<Real>(found.search.Sets()[0], found.search.Sets(), found.positions, found.search.CurrentReach(),
                         block);
  }
  found.search.Finish();
  found.mass.assign(sorted.mass.begin(), sorted.mass.end());
  found.mass.resize(sorted.Size() + kPadding);
  return found;
}
template Neighbourhood<float> FindNeighbours<float>(const Cloud&, double);
template Neighbourhood<double> FindNeighbours<double>(const Cloud&, double);

void WithEveryInstructionSet(const std::function<void()>& test) {
  for (const std::string& set : AvailableInstructionSets()) {
    SCOPED_TRACE(set);
    UseInstructionSet(set, "test");
    test();
  }
  UseInstructionSet("best", "test");
}

}  // namespace sph
