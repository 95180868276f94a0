// The grid misses no pair, whatever the particles do, and its memory follows their number.
#include "neighbours/cell_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sph {
namespace {

constexpr double kSide = 0.5;  // [m], a power of two: points on cell boundaries are there exactly

struct Points {
  std::vector<double> x, y;

  void Add(double px, double py) {
    x.push_back(px);
    y.push_back(py);
  }
  /// The same points in the order of the grid, as a solver sorts them.
  Points Sorted(const CellGrid& grid) const {
    Points sorted;
    for (const std::uint32_t i : grid.Order()) sorted.Add(x[i], y[i]);
    return sorted;
  }
};

CellGrid GridOf(const Points& points, double side = kSide) {
  CellGrid grid;
  grid.Build(points.x, points.y, side);
  return grid;
}

/// From a lattice of a quarter of a side: many coincide, many lie on cell boundaries, many exactly a side apart.
rc::Gen<std::vector<std::pair<int, int>>> Clumps(int extent) {
  const auto coordinate = rc::gen::inRange(-extent, extent + 1);
  return rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(coordinate, coordinate));
}

Points PointsFrom(const std::vector<std::pair<int, int>>& steps) {
  Points points;
  for (const auto& [column, row] : steps) points.Add(0.25 * kSide * column, 0.25 * kSide * row);
  return points;
}

/// Numbers (in the grid's order) of the points that FindCells offers at `position`; counted, so that none comes twice.
std::multiset<std::uint32_t> Offered(const CellGrid& grid, Vec2 position) {
  std::multiset<std::uint32_t> offered;
  for (const Run& run : grid.FindCells(position)) {
    for (std::uint32_t k = run.first; k < run.last; ++k) offered.insert(k);
  }
  return offered;
}

/// The first pair within a side that the grid does not offer, in words; empty if there is none.
std::string MissedPair(const Points& points, double side = kSide) {
  const CellGrid grid = GridOf(points, side);
  const Points p = points.Sorted(grid);
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const auto offered = Offered(grid, {p.x[i], p.y[i]});
    for (std::uint32_t j = 0; j < p.x.size(); ++j) {
      const bool near = std::hypot(p.x[i] - p.x[j], p.y[i] - p.y[j]) < side;
      if (offered.count(j) > 1 || (near && offered.count(j) == 0)) {
        return "(" + std::to_string(p.x[i]) + ", " + std::to_string(p.y[i]) + ") is offered (" +
               std::to_string(p.x[j]) + ", " + std::to_string(p.y[j]) + ") " + std::to_string(offered.count(j)) +
               " times";
      }
    }
  }
  return {};
}

RC_GTEST_PROP(CellGrid, OffersEveryPairWithinASideOnceInAClump, ()) {
  RC_ASSERT(MissedPair(PointsFrom(*Clumps(10))) == "");
}

RC_GTEST_PROP(CellGrid, OffersEveryPairWithinASideOnceWhereParticlesAreSparse, ()) {
  RC_ASSERT(MissedPair(PointsFrom(*Clumps(2000))) == "");
}

RC_GTEST_PROP(CellGrid, OffersEveryPairWhenSomeHaveEscapedFarAway, ()) {
  Points points = PointsFrom(*Clumps(6));
  for (const auto& [column, row] : *Clumps(6)) points.Add(1e6 + 0.25 * kSide * column, -1e7 + 0.25 * kSide * row);
  for (const auto& [column, row] : *Clumps(3)) points.Add(3e5 * column, 2e5 * row);
  RC_ASSERT(MissedPair(points) == "");
}

RC_GTEST_PROP(CellGrid, OffersEveryPairAtArbitraryPositionsAndSides, ()) {
  // Numbers that are no multiples of anything. A pair that is nearer than a side by round-off of its positions may fall
  // on either side of "within": the kernel is 0 there.
  const double side = *rc::gen::map(rc::gen::inRange(1, 100000), [](int k) { return k / 77777.0; });
  Points points;
  for (const auto& [a, b] : *Clumps(100000)) points.Add(a / 33333.0, b / 33333.0);
  RC_ASSERT(MissedPair(points, side) == "");
}

RC_GTEST_PROP(CellGrid, OrderIsAPermutationSortedByCellAndStable, ()) {
  const Points points = PointsFrom(*Clumps(12));
  const CellGrid grid = GridOf(points);
  const auto order = grid.Order();
  std::vector<std::uint32_t> sorted(order.begin(), order.end());
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t k = 0; k < points.x.size(); ++k) RC_ASSERT(sorted[k] == k);
  // The covered box begins at the least coordinates; the cell of a point follows by division.
  const auto cell = [&](std::uint32_t i) {
    const double x0 = *std::min_element(points.x.begin(), points.x.end());
    const double y0 = *std::min_element(points.y.begin(), points.y.end());
    return std::pair(std::floor((points.y[i] - y0) / kSide), std::floor((points.x[i] - x0) / kSide));
  };
  for (std::size_t k = 1; k < order.size(); ++k) {
    RC_ASSERT(std::pair(cell(order[k - 1]), order[k - 1]) < std::pair(cell(order[k]), order[k]));
  }
}

RC_GTEST_PROP(CellGrid, SaysWhetherTheParticlesWereInOrderAlready, ()) {
  const Points points = PointsFrom(*Clumps(12));
  const CellGrid grid = GridOf(points);
  RC_ASSERT(grid.InOrder() == std::is_sorted(grid.Order().begin(), grid.Order().end()));
  RC_ASSERT(GridOf(points.Sorted(grid)).InOrder());
}

RC_GTEST_PROP(CellGrid, RunsStayWithinTheParticlesForAnyPosition, ()) {
  const Points points = PointsFrom(*Clumps(12));
  const CellGrid grid = GridOf(points);
  const double far = *rc::gen::element(0.0, 1.0, 1e9, 1e300);
  for (const Vec2 position : {Vec2{far, far}, Vec2{-far, far}, Vec2{far, -far}, Vec2{-far, -far}}) {
    for (const Run& run : grid.FindCells(position)) {
      RC_ASSERT(run.first <= run.last);
      RC_ASSERT(run.last <= points.x.size());
    }
  }
}

TEST(CellGrid, OfNoParticlesFindsNone) {
  const CellGrid grid = GridOf({});
  EXPECT_TRUE(grid.Order().empty());
  EXPECT_TRUE(grid.InOrder());
  EXPECT_TRUE(Offered(grid, {0, 0}).empty());
}

TEST(CellGrid, OfOneParticleFindsItThere) {
  Points points;
  points.Add(-3, 1e12);
  EXPECT_EQ(Offered(GridOf(points), {-3, 1e12}), std::multiset<std::uint32_t>{0});
}

TEST(CellGrid, AllParticlesInOnePlaceAreOneCell) {
  Points points;
  for (int k = 0; k < 1000; ++k) points.Add(0.3, -0.7);
  const CellGrid grid = GridOf(points);
  EXPECT_EQ(grid.Columns() * grid.Rows(), 1);
  EXPECT_EQ(Offered(grid, {0.3, -0.7}).size(), 1000u);
}

TEST(CellGrid, OffersOnlyTheNineCellsAround) {
  Points points;  // one in the middle of each cell of a 9 x 9 grid
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < 9; ++column) points.Add(kSide * column, kSide * row);
  }
  EXPECT_EQ(Offered(GridOf(points), {kSide * 4.5, kSide * 4.5}).size(), 9u);
}

TEST(CellGrid, MemoryFollowsTheNumberOfParticlesHoweverFarTheyAre) {
  for (const double distance : {1e3, 1e8, 1e150}) {
    Points points;
    for (int k = 0; k < 500; ++k) points.Add(0.01 * k, 0.02 * k);
    points.Add(distance, 0);
    points.Add(-distance, distance);
    points.Add(0, -distance);
    const CellGrid grid = GridOf(points);
    EXPECT_LE(grid.Columns() * grid.Rows(), 4 * 503 + 1024) << distance;  // Build's promise: cells in proportion to N
    EXPECT_EQ(MissedPair(points), "") << distance;
  }
}

TEST(CellGrid, ALongThinStreamIsCoveredToItsEnds) {
  Points
      points;  // 2000 cells long, one cell high: within the memory, so that no cell has to take two places' particles
  for (int k = 0; k < 1000; ++k) points.Add(2 * kSide * k, 0);
  const CellGrid grid = GridOf(points);
  EXPECT_GE(grid.Columns(), 1999);
  for (int k = 0; k < 1000; ++k) EXPECT_LE(Offered(grid, {2 * kSide * k, 0}).size(), 2u);
}

TEST(CellGrid, RefusesASideThatIsNotPositiveAndPositionsThatAreNotFinite) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  Points points;
  points.Add(0, 0);
  EXPECT_DEATH(GridOf(points, 0), "side = 0");
  points.Add(INFINITY, 0);
  EXPECT_DEATH(GridOf(points), "positions from");
}

}  // namespace
}  // namespace sph
