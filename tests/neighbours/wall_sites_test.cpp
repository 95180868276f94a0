// Wall sites against every point of the lattice: those behind walls that a particle can see are there, each once.
#include "neighbours/wall_sites.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/random.hpp"

namespace sph {
namespace {

constexpr double kSpacing = 0.1, kReach = 0.42;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

struct Points {
  std::vector<double> x, y;
};

Points Scattered(std::size_t n, const Box& box, std::uint64_t seed = 1) {
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    points.x.push_back(random.Uniform(box.x0, box.x1));
    points.y.push_back(random.Uniform(box.y0, box.y1));
  }
  return points;
}

std::vector<Vec2> PlacesOf(const WallSites& sites, const Ends& ends) {
  std::vector<double> x, y;
  sites.Place(ends, x, y);
  std::vector<Vec2> places;
  for (std::size_t k = 0; k < x.size(); ++k) places.push_back({x[k], y[k]});
  return places;
}

WallSites Found(const Ends& ends, const Points& points) {
  WallSites sites;
  sites.Find(ends, kReach, points.x, points.y);
  return sites;
}

struct Shape {
  const char* name;
  Ends ends;
};
class WallSitesOf : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Ends, WallSitesOf,
                         testing::Values(Shape{"ATank", {{0, 2}, {0, kNowhere}, kSpacing}},
                                         Shape{"ABox", {{0, 2}, {-1, 0.5}, kSpacing}},
                                         Shape{"AFloor", {{-kNowhere, kNowhere}, {0, kNowhere}, kSpacing}},
                                         Shape{"ACeiling", {{-kNowhere, 2}, {-kNowhere, 1.5}, kSpacing}},
                                         Shape{"AChannel", {{0, 2, true}, {0, 1.5}, kSpacing}}),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(WallSitesOf, AreAllThatAParticleMaySeeBehindWallsEachOnce) {
  const Ends& ends = GetParam().ends;
  const auto finite = [](double end, double otherwise) { return std::isfinite(end) ? end : otherwise; };
  const Box box{finite(ends.x.low, 0.3), finite(ends.y.low, 0.2), finite(ends.x.high, 1.7), finite(ends.y.high, 1.3)};
  const Points points = Scattered(60, box);
  const auto places = PlacesOf(Found(ends, points), ends);
  const auto behind = [](const AxisEnds& axis, double at) {
    return !axis.periodic && (at < axis.low || at > axis.high);
  };
  std::set<std::pair<long, long>> there;
  for (const Vec2 place : places) {
    EXPECT_TRUE(behind(ends.x, place.x) || behind(ends.y, place.y)) << place.x << ", " << place.y;
    EXPECT_TRUE(there.emplace(std::lround(place.x / kSpacing - 0.5), std::lround(place.y / kSpacing - 0.5)).second);
  }
  for (long column = -20; column < 50; ++column) {
    for (long row = -20; row < 50; ++row) {
      const double x = (static_cast<double>(column) + 0.5) * kSpacing;
      const double y = (static_cast<double>(row) + 0.5) * kSpacing;
      if (!behind(ends.x, x) && !behind(ends.y, y)) continue;
      bool seen = false;
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        seen = seen || std::hypot(points.x[i] - x, points.y[i] - y) < kReach;
      }
      EXPECT_TRUE(!seen || there.count({column, row}) == 1) << x << ", " << y;
    }
  }
}

TEST(WallSites, FitBetweenWallsThatAreNoMultipleOfTheSpacingApart) {
  const Ends ends{{0, 1.04}, {0, kNowhere}, kSpacing};
  double least = 1, greatest = 0;  // of those below the floor
  for (const Vec2 place : PlacesOf(Found(ends, Scattered(200, {0, 0, 1.04, 0.5})), ends)) {
    if (place.x < 0 || place.x > 1.04) continue;
    least = std::min(least, place.x);
    greatest = std::max(greatest, place.x);
  }
  EXPECT_NEAR(least, 0.052, 1e-12) << "half of a tenth of 1.04";
  EXPECT_NEAR(greatest, 1.04 - 0.052, 1e-12);
}

TEST(WallSites, GoWithAWallThatHasMoved) {
  const Ends before{{0, 1}, {0, kNowhere}, kSpacing}, after{{0, 1.01}, {0, kNowhere}, kSpacing};
  const WallSites sites = Found(before, Scattered(200, {0, 0, 1, 0.5}));
  const auto from = PlacesOf(sites, before), to = PlacesOf(sites, after);
  for (std::size_t k = 0; k < from.size(); ++k) {
    EXPECT_NEAR(to[k].x, 1.01 * from[k].x, 1e-12);
    EXPECT_EQ(to[k].y, from[k].y);
  }
}

TEST(WallSites, OfWallsThatMeetAreNoMoreThanLayersOfThem) {
  Points points;
  points.x = points.y = {0.5};
  for (const double high : {0.5 + 1e-12, 0.5, 0.4}) {
    EXPECT_LT(Found({{0.5, high}, {0, kNowhere}, kSpacing}, points).Size(), 500u) << high;
  }
}

TEST(WallSites, OfFluidFarApartAreNoMoreThanThatOfFluidTogether) {
  Points points = Scattered(2, {0, 0, 0.01, 0.01});
  const Ends ends{{-kNowhere, kNowhere}, {0, kNowhere}, kSpacing};
  const std::size_t together = Found(ends, points).Size();
  points.x[1] = 1e6;
  EXPECT_EQ(Found(ends, points).Size(), 2 * together);
  points.x[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Found(ends, points).Size(), together);
  points.x[1] = 1e300;
  EXPECT_EQ(Found(ends, points).Size(), together);
}

TEST(WallSites, OfMirrorsAndOfFluidAwayFromWallsAreNone) {
  EXPECT_EQ(Found({{0, 1}, {0, 1}}, Scattered(50, {0, 0, 1, 1})).Size(), 0u);
  EXPECT_EQ(Found({{0, 9}, {0, 9}, kSpacing}, Scattered(50, {4, 4, 5, 5})).Size(), 0u);
}

TEST(WallSites, ReorderTakesEveryOneAlong) {
  const Ends ends{{0, 1}, {0, 1}, kSpacing};
  WallSites sites = Found(ends, Scattered(50, {0, 0, 1, 1}));
  auto places = PlacesOf(sites, ends);
  std::vector<std::uint32_t> backwards(sites.Size());
  for (std::size_t k = 0; k < backwards.size(); ++k)
    backwards[k] = static_cast<std::uint32_t>(backwards.size() - 1 - k);
  sites.Reorder(backwards);
  std::ranges::reverse(places);
  EXPECT_TRUE(PlacesOf(sites, ends) == places);
}

}  // namespace
}  // namespace sph
