// The neighbours found through the grid are those that all pairs give.
#include "sph/neighbour_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sph/clouds.hpp"

namespace sph {
namespace {

constexpr double kReach = 2 * kCloudH;

TEST(NeighbourBlock, HoldsTheSameSetAsAllPairs) {
  for (const Cloud& given : AllClouds()) {
    const auto [cloud, blocks] = FindNeighbours(given, kReach);
    for (const NeighbourBlock& block : blocks) {
      for (std::size_t k = 0; k < block.Size(); ++k) {
        const std::size_t i = block.First() + k;
        std::set<std::uint32_t> expected;
        for (std::uint32_t j = 0; j < cloud.Size(); ++j) {
          const double dx = cloud.x[i] - cloud.x[j];
          const double dy = cloud.y[i] - cloud.y[j];
          if (j != i && dx * dx + dy * dy < kReach * kReach) expected.insert(j);
        }
        const auto numbers = block.Numbers(k);
        ASSERT_EQ(std::set<std::uint32_t>(numbers.begin(), numbers.end()), expected)
            << cloud.name << ", particle " << i;
        ASSERT_EQ(numbers.size(), expected.size()) << "one twice: " << cloud.name << ", particle " << i;
      }
    }
  }
}

TEST(NeighbourBlock, KeepsEachNeighboursDistance) {
  for (const Cloud& given : AllClouds()) {
    const auto [cloud, blocks] = FindNeighbours(given, kReach);
    for (const NeighbourBlock& block : blocks) {
      for (std::size_t k = 0; k < block.Size(); ++k) {
        const std::size_t i = block.First() + k;
        ASSERT_EQ(block.Distances(k).size(), block.Numbers(k).size());
        for (std::size_t n = 0; n < block.Numbers(k).size(); ++n) {
          const std::uint32_t j = block.Numbers(k)[n];
          const double r = std::hypot(cloud.x[i] - cloud.x[j], cloud.y[i] - cloud.y[j]);
          ASSERT_NEAR(block.Distances(k)[n], r, 4e-16 * r)
              << cloud.name;  // two roundings of the root of a sum of squares
        }
      }
    }
  }
}

TEST(NeighbourBlock, BlocksTogetherHoldEveryParticleOnce) {
  for (const Cloud& given : AllClouds()) {
    std::size_t next = 0;
    for (const NeighbourBlock& block : FindNeighbours(given, kReach).blocks) {
      EXPECT_EQ(block.First(), next) << given.name;
      next += block.Size();
    }
    EXPECT_EQ(next, given.Size()) << given.name;
  }
}

TEST(NeighbourBlock, AParticleIsNotItsOwnNeighbourButOneInTheSamePlaceIs) {
  Cloud cloud;
  cloud.x = {0.1, 0.1, 0.1};
  cloud.y = {0.2, 0.2, 0.2};
  cloud.vx = cloud.vy = cloud.mass = {1, 1, 1};
  const NeighbourBlock block = FindNeighbours(cloud, kReach).blocks.front();
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto numbers = block.Numbers(i);
    EXPECT_EQ(numbers.size(), 2u);
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), i), 0);
  }
  EXPECT_EQ(block.Pairs(), 6u);
}

TEST(NeighbourBlock, AParticleExactlyAtTheReachIsNoNeighbour) {
  Cloud cloud;
  cloud.x = {0, 0.5, 1.0};
  cloud.y = {0, 0, 0};
  cloud.vx = cloud.vy = cloud.mass = {1, 1, 1};
  EXPECT_EQ(FindNeighbours(cloud, 0.5).blocks.front().Pairs(), 0u);
  EXPECT_EQ(FindNeighbours(cloud, std::nextafter(0.5, 1)).blocks.front().Pairs(), 4u);
}

TEST(NeighbourBlock, HoldsMoreThanThePapersForty) {
  Cloud cloud;  // everyone is everyone's neighbour
  for (int k = 0; k < 500; ++k) {
    cloud.x.push_back(1e-6 * k);
    cloud.y.push_back(0);
  }
  cloud.vx = cloud.vy = cloud.mass = cloud.x;
  std::size_t pairs = 0;
  for (const NeighbourBlock& block : FindNeighbours(cloud, kReach).blocks) pairs += block.Pairs();
  EXPECT_EQ(pairs, 500u * 499u);
}

TEST(NeighbourBlock, ForgetsThePreviousSearch) {
  CellGrid grid;
  std::vector<double> x = {0, 0.01, 0.02}, y = {0, 0, 0};
  grid.Build(x, y, kReach);
  NeighbourBlock block;
  block.Find(grid, x, y, kReach, 0, 3);
  ASSERT_EQ(block.Pairs(), 6u);
  x = {0, 10, 20};
  grid.Build(x, y, kReach);
  block.Find(grid, x, y, kReach, 0, 3);
  EXPECT_EQ(block.Pairs(), 0u);
}

}  // namespace
}  // namespace sph
