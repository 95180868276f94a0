// Arrays that stay of one length, and a reordering that loses nobody.
#include "particles/particles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace sph {
namespace {

/// n particles, all of whose numbers tell who they are.
Particles Numbered(std::size_t n) {
  Particles p;
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<double>(i);
    p.Add({k, k + 0.1}, {k + 0.2, k + 0.3}, k + 0.4);
    p.ax[i] = k + 0.5;
    p.ay[i] = k + 0.6;
    p.vx_prev[i] = k + 0.7;
    p.vy_prev[i] = k + 0.8;
  }
  return p;
}

TEST(Particles, AddedOnesAreAtRestSinceHalfAStepAndNumberedInTurn) {
  Particles p;
  p.Add({1, 2}, {3, 4}, 5);
  p.Add({6, 7}, {8, 9}, 10);
  ASSERT_EQ(p.Size(), 2u);
  EXPECT_EQ(p.id, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(p.Position(1), (Vec2{6, 7}));
  EXPECT_EQ(p.Velocity(1), (Vec2{8, 9}));
  EXPECT_EQ(p.vx_prev[1], 8);
  EXPECT_EQ(p.vy_prev[1], 9);
  EXPECT_EQ(p.ax[1], 0);
  EXPECT_EQ(p.mass[1], 10);
}

TEST(Particles, TakeNoMoreRoomThanWasReserved) {
  Particles p;
  p.Reserve(1000);
  const std::size_t reserved = p.Bytes();
  EXPECT_EQ(reserved, 1000 * (9 * sizeof(double) + sizeof(std::uint32_t)));
  for (int i = 0; i < 1000; ++i) p.Add({}, {}, 1);
  EXPECT_EQ(p.Bytes(), reserved);
}

RC_GTEST_PROP(Particles, ReorderMovesEveryParticleWhole, ()) {
  const auto keys = *rc::gen::container<std::vector<int>>(rc::gen::arbitrary<int>());
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  Particles p = Numbered(keys.size());
  p.Reorder(order);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double who = order[k];
    RC_ASSERT(p.id[k] == order[k]);
    const std::vector<double> found = {p.x[k],  p.y[k],  p.vx[k],      p.vy[k],     p.mass[k],
                                       p.ax[k], p.ay[k], p.vx_prev[k], p.vy_prev[k]};
    const std::vector<double> expected = {who,       who + 0.1, who + 0.2, who + 0.3, who + 0.4,
                                          who + 0.5, who + 0.6, who + 0.7, who + 0.8};
    RC_ASSERT(found == expected);
  }
}

TEST(Particles, ClearLeavesNothing) {
  Particles p = Numbered(5);
  p.Clear();
  EXPECT_EQ(p.Size(), 0u);
  p.Add({1, 2}, {0, 0}, 1);
  EXPECT_EQ(p.id, std::vector<std::uint32_t>{0});
  EXPECT_EQ(p.vx_prev.size(), 1u);
}

TEST(Particles, ReorderRefusesAnOrderOfAnotherLength) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  Particles p = Numbered(3);
  EXPECT_DEATH(p.Reorder(std::vector<std::uint32_t>{0, 1}), "2 places for 3 particles");
}

}  // namespace
}  // namespace sph
