// Clusters and their lists: every particle once, every pair within reach once, also after the particles have moved.
#include "neighbours/neighbour_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.hpp"

namespace sph {
namespace {

constexpr double kSupport = 0.5;  // [m]
constexpr double kSpacing = 0.2;

/// Points as a solver holds them: sorted into clusters, with lists of what is within reach.
template <typename Real>
struct Found {
  explicit Found(std::vector<double> px, std::vector<double> py) : Found(px, py, std::vector<Vec2>(px.size()), 0) {}
  /// Particles with velocities, which have made a step of that length [s].
  Found(const std::vector<double>& px, const std::vector<double>& py, const std::vector<Vec2>& velocities,
        double step_length)
      : step(step_length) {
    search.NextTask(0, kSupport);
    search.Sort(px, py, kSpacing, Lanes<Real>());
    for (const std::uint32_t i : search.Order()) {
      x.push_back(px[i]);
      y.push_back(py[i]);
      vx.push_back(velocities[i].x);
      vy.push_back(velocities[i].y);
    }
    search.Cut(x, y);
    Find();
  }
  void Find() {
    SetPositions();
    search.AreCompact(x, y);
    search.Prepare({x, y, vx, vy, vx, vy, time, step});
    for (ListBlock& block : search.Blocks()) {
      FindNeighbours<Real>(search.Sets()[0], search.Sets(), positions, search.CurrentReach(), block);
    }
    search.Finish();
  }
  /// Whether lists hold once the particles have gone on.
  bool HoldAfterStep() {
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += step * vx[i];
      y[i] += step * vy[i];
    }
    time += step;
    SetPositions();
    return search.NextTask(time, kSupport) == SearchTask::kNothing && search.Hold(positions, time);
  }
  void SetPositions() {
    positions.Resize(x.size());
    positions.Set(x, y, kSupport, 0, x.size());
  }

  std::vector<double> x, y, vx, vy;
  double time = 0, step = 0;
  NeighbourSearch search;
  Positions<Real> positions;
};

/// What is wrong with the lists, in words: a pair within `reach` that is missing, or a particle that is listed twice.
template <typename Real>
std::string Wrong(const Found<Real>& found, double reach) {
  for (const ListBlock& block : found.search.Blocks()) {
    for (std::uint32_t k = block.first; k < block.last; ++k) {
      const auto list = block.Of(k);
      const std::set<std::uint32_t> listed(list.begin(), list.end());
      if (listed.size() != list.size()) return "a particle is listed twice";
      const Cluster& cluster = found.search.Clusters()[k];
      for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
        for (std::uint32_t j = 0; j < found.x.size(); ++j) {
          const double r = std::hypot(found.x[i] - found.x[j], found.y[i] - found.y[j]);
          if (r < reach && !listed.contains(j)) return "a pair " + std::to_string(r) + " m apart is missing";
        }
      }
    }
  }
  return {};
}

/// From a lattice of an eighth of the support: many coincide, many are exactly the support apart.
rc::Gen<std::vector<std::pair<int, int>>> Clumps(int extent) {
  const auto coordinate = rc::gen::inRange(-extent, extent + 1);
  return rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(coordinate, coordinate));
}

template <typename Real>
Found<Real> FoundOf(const std::vector<std::pair<int, int>>& steps, double scale = kSupport / 8) {
  std::vector<double> x, y;
  for (const auto& [column, row] : steps) {
    x.push_back(scale * column);
    y.push_back(scale * row);
  }
  return Found<Real>(x, y);
}

template <typename Real>
void CheckAllKinds() {
  RC_ASSERT(Wrong(FoundOf<Real>(*Clumps(10)), kSupport) == "");
  RC_ASSERT(Wrong(FoundOf<Real>(*Clumps(300)), kSupport) == "");
  RC_ASSERT(Wrong(FoundOf<Real>(*Clumps(1000), 1234.5), kSupport) == "");  // escaped, each alone
}

RC_GTEST_PROP(NeighbourSearch, ListsEveryPairWithinReachOnceInDouble, ()) { CheckAllKinds<double>(); }
RC_GTEST_PROP(NeighbourSearch, ListsEveryPairWithinReachOnceInFloat, ()) { CheckAllKinds<float>(); }

RC_GTEST_PROP(NeighbourSearch, ClustersHoldEveryParticleOnceAndAreNeverTooLong, ()) {
  const auto found = FoundOf<float>(*Clumps(200));
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < found.search.Clusters().size(); ++k) {
    const Cluster& cluster = found.search.Clusters()[k];
    RC_ASSERT(cluster.first == next);
    RC_ASSERT(cluster.count >= 1u && cluster.count <= static_cast<unsigned>(Lanes<float>()));
    const Box& box = found.search.Boxes().Of(k);
    RC_ASSERT(std::max(box.Width(), box.Height()) <= ClusterOrder::kLongestInSupports * kSupport);
    next += cluster.count;
  }
  RC_ASSERT(next == found.x.size());
}

/// Moves particles until the lists no longer hold, some of them suddenly another way; how many steps that took.
template <typename Real>
int StepsThatListsHold() {
  const auto steps = *Clumps(30);
  RC_PRE(!steps.empty());
  std::vector<double> x, y;
  for (const auto& [column, row] : steps) {
    x.push_back(kSupport / 8 * column);
    y.push_back(kSupport / 8 * row);
  }
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto random_velocity = [&](double greatest) {
    return Vec2{random.Uniform(-greatest, greatest), random.Uniform(-greatest, greatest)};
  };
  const Vec2 common = random_velocity(2);  // [m/s]
  std::vector<Vec2> velocities;
  for (std::size_t i = 0; i < x.size(); ++i) velocities.push_back(common + random_velocity(0.3));
  Found<Real> found(x, y, velocities, 0.002);
  RC_ASSERT(found.search.Horizon() > 0);
  int held = 0;
  for (; found.HoldAfterStep(); ++held) {
    RC_ASSERT(Wrong(found, kSupport * (1 - 1e-6)) == "");
    for (std::size_t i = 0; i < found.x.size(); ++i) {
      const Vec2 push = random_velocity(0.05);
      found.vx[i] += push.x;
      found.vy[i] += push.y;
    }
  }
  return held;
}

RC_GTEST_PROP(NeighbourSearch, ListsHoldEveryPairUntilAParticleIsOffItsCourseInDouble, ()) {
  StepsThatListsHold<double>();
}
RC_GTEST_PROP(NeighbourSearch, ListsHoldEveryPairUntilAParticleIsOffItsCourseInFloat, ()) {
  StepsThatListsHold<float>();
}

TEST(NeighbourSearch, ListsOfWhatMovesTogetherHoldUntilTheHorizon) {
  std::vector<double> x, y;
  std::vector<Vec2> velocities;
  for (int k = 0; k < 2500; ++k) {
    x.push_back(kSpacing * (k % 50));
    y.push_back(kSpacing * (k / 50));
    velocities.push_back({3 - 0.02 * y.back(), 0.02 * x.back()});  // [m/s]: turns slowly on its way
  }
  Found<float> found(x, y, velocities, 0.001);
  EXPECT_GT(found.search.Horizon(), 20 * found.step);
  int held = 0;
  while (found.HoldAfterStep()) ++held;
  EXPECT_NEAR(held, found.search.Horizon() / found.step, 1);
  const std::vector<ListBlock>& blocks = found.search.Blocks();
  for (const ListBlock& block : blocks) {
    for (const float reach : block.reach) EXPECT_LT(reach, 1.1) << "by 0.1 supports, while all travel 0.2";
  }
}

TEST(NeighbourSearch, OneThatLeavesItsCourseEndsTheLists) {
  std::vector<double> x, y;
  for (int k = 0; k < 400; ++k) {
    x.push_back(kSpacing * (k % 20));
    y.push_back(kSpacing * (k / 20));
  }
  Found<double> found(x, y, std::vector<Vec2>(400, Vec2{1, 1}), 0.001);
  ASSERT_TRUE(found.HoldAfterStep());
  found.x[123] += 0.01 * kSupport;
  EXPECT_FALSE(found.HoldAfterStep());
}

TEST(NeighbourSearch, ClustersAreCompactUntilTheirParticlesHaveDriftedApart) {
  std::vector<double> x, y;
  for (int k = 0; k < 400; ++k) {
    x.push_back(kSpacing * (k % 20));
    y.push_back(kSpacing * (k / 20));
  }
  Found<double> found(x, y);
  EXPECT_TRUE(found.search.AreCompact(found.x, found.y));
  found.x[0] -= 5 * kSupport;
  EXPECT_FALSE(found.search.AreCompact(found.x, found.y));
}

TEST(NeighbourSearch, OfNoParticlesHasNoClusters) {
  const Found<float> found({}, {});
  EXPECT_TRUE(found.search.Clusters().empty());
  EXPECT_TRUE(found.search.Blocks().empty());
}

TEST(NeighbourSearch, SortsAgainWhenDriftHasMadeTheListsLong) {
  std::vector<double> x, y;
  for (int k = 0; k < 2500; ++k) {
    x.push_back(kSpacing * (k % 50));
    y.push_back(kSpacing * (k / 50));
  }
  Found<float> found(x, y);
  EXPECT_EQ(found.search.NextTask(0, kSupport), SearchTask::kNothing);
  for (std::size_t i = 0; i < found.x.size(); ++i) found.x[i] += i % 3 == 0 ? 3 * kSpacing : 0;  // clusters torn apart
  found.Find();
  EXPECT_EQ(found.search.NextTask(0, kSupport), SearchTask::kSort);
}

TEST(NeighbourSearch, ListsOfALatticeAreNotMuchLongerThanTheNeighbours) {
  // 16 particles in a square of 4 x 4 spacings reach (16 + 16 R + pi R^2) dx^2, R = 2.5 spacings: 76 particles; 8 and 4
  // reach fewer.
  std::vector<double> x, y;
  for (int k = 0; k < 10000; ++k) {
    x.push_back(kSpacing * (k % 100));
    y.push_back(kSpacing * (k / 100));
  }
  const Found<float> found(x, y);
  std::size_t entries = 0;
  for (const ListBlock& block : found.search.Blocks()) entries += block.begin.back();
  EXPECT_LT(static_cast<double>(entries) / static_cast<double>(found.search.Clusters().size()), 76);
}

TEST(NeighbourSearch, MemoryFollowsTheNumberOfParticlesHoweverFarTheyAre) {
  for (const double distance : {1e3, 1e8, 1e150}) {
    std::vector<double> x, y;
    for (int k = 0; k < 500; ++k) {
      x.push_back(0.01 * k);
      y.push_back(0.02 * k);
    }
    x.insert(x.end(), {distance, -distance, 0});
    y.insert(y.end(), {0, distance, -distance});
    const Found<double> found(x, y);
    EXPECT_LE(found.search.Bytes(), 503u * 1000) << distance;
    EXPECT_EQ(Wrong(found, kSupport), "") << distance;
  }
}

TEST(Positions, DifferencesAreExactToFloatFarFromTheOrigin) {
  const std::vector<double> x = {1e6 * kSupport, 1e6 * kSupport + 0.3 * kSupport};
  Positions<float> positions;
  positions.Resize(x.size());
  positions.Set(x, x, kSupport, 0, x.size());
  const double unit = Positions<float>::Unit(kSupport);
  EXPECT_NEAR((positions.X()[1] - positions.X()[0]) * unit, x[1] - x[0], unit);
}

TEST(ClusterOrder, LeavesNobodyOutWhoIsNowhere) {
  const double nan = std::nan("");
  for (const double nowhere : {nan, -nan, static_cast<double>(INFINITY), -static_cast<double>(INFINITY), 1e308}) {
    ClusterOrder order;
    std::vector<double> x = {0, 5, 1e9, nowhere, 1, nowhere}, y = {0, nowhere, 0, 0, -1e300, nowhere};
    order.Sort(x, y, kSpacing, kSupport, 8);
    std::vector<std::uint32_t> all(order.Order().begin(), order.Order().end());
    std::ranges::sort(all);
    EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5})) << nowhere;
    order.Cut(x, y, kSupport, 8);
    std::size_t count = 0;
    for (const Cluster& cluster : order.Clusters()) count += cluster.count;
    EXPECT_EQ(count, 6u) << nowhere;
  }
}

}  // namespace
}  // namespace sph
