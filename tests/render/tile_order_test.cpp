#include "render/tile_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sph {
namespace {

TEST(TileOrder, IsTheStableOrderByTile) {
  EXPECT_TRUE(rc::check([] {
    const int width = *rc::gen::inRange(1, 400);
    const int height = *rc::gen::inRange(1, 400);
    std::vector<DiskVertex> disks;
    for (int n = *rc::gen::inRange(0, 200); n > 0; --n) {  // also outside the window
      disks.push_back({0.5F * static_cast<float>(*rc::gen::inRange(-500, 500)),
                       0.5F * static_cast<float>(*rc::gen::inRange(-500, 500)),
                       {static_cast<std::uint8_t>(n), 0, 0}});
    }
    std::vector<DiskVertex> sorted(disks.size());
    SortByTile(disks, sorted, width, height);

    const auto tile = [](float coordinate, int size) {  // the plain definition
      return std::floor(std::clamp(coordinate + 0.5F * static_cast<float>(size), 0.0F, static_cast<float>(size - 1)) /
                        64);
    };
    std::stable_sort(disks.begin(), disks.end(), [&](const DiskVertex& a, const DiskVertex& b) {
      return std::pair(tile(a.y, height), tile(a.x, width)) < std::pair(tile(b.y, height), tile(b.x, width));
    });
    RC_ASSERT(sorted == disks);
  }));
}

}  // namespace
}  // namespace sph
