// The area that particles fill: that of lattices whatever their shape, less where they come closer.
#include "lab/filled_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/random.hpp"

namespace sph {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr Box kNoBounds{-kFar, -kFar, kFar, kFar};

std::vector<Vec2> Lattice(int columns, int rows, Vec2 spacing) {
  std::vector<Vec2> points;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      points.push_back({(column + 0.5) * spacing.x, (row + 0.5) * spacing.y});
  }
  return points;
}

TEST(FilledShapeOf, LatticeInATankIsItsColumnsTimesItsRows) {
  const auto shape = FilledShapeOf(Lattice(12, 10, {0.1, 0.1}), 0.1, {0, 0, 1.2, kFar}).value();
  EXPECT_NEAR(shape.area, 1.2, 0.01 * 1.2) << "a twelfth of a spacing at the surface";
  EXPECT_NEAR(shape.edge, 1.2, 0.1 * 1.2);
}

TEST(FilledShapeOf, FreeLatticeOnlyLosesItsCorners) {
  const auto shape = FilledShapeOf(Lattice(14, 14, {1, 1}), 1, kNoBounds).value();
  EXPECT_NEAR(shape.area, 14 * 14, 0.02 * 14 * 14);
}

TEST(FilledShapeOf, DiskHasTheAreaAndTheEdgeOfADisk) {
  std::vector<Vec2> points;
  for (const Vec2 p : Lattice(40, 40, {0.1, 0.1})) {
    if (Length(p - Vec2{2, 2}) < 1.5) points.push_back(p);
  }
  const auto shape = FilledShapeOf(points, 0.1, kNoBounds).value();
  EXPECT_NEAR(shape.area, static_cast<double>(points.size()) * 0.01, 0.02 * static_cast<double>(points.size()) * 0.01);
  EXPECT_NEAR(shape.edge, 3 * std::acos(-1.0), 0.1 * 3 * std::acos(-1.0));
}

TEST(FilledShapeOf, DisorderChangesNothing) {
  auto points = Lattice(14, 14, {1, 1});
  Random random(1);
  for (Vec2& p : points) p = p + Vec2{random.Uniform(-0.25, 0.25), random.Uniform(-0.25, 0.25)};
  EXPECT_NEAR(FilledShapeOf(points, 1, {0, 0, 14, kFar}).value().area, 14 * 14, 0.02 * 14 * 14);
}

TEST(FilledShapeOf, StretchedLatticeGrowsAndSqueezedOneSinks) {
  const Box tank{0, 0, 14, kFar};
  EXPECT_NEAR(FilledShapeOf(Lattice(14, 14, {1, 1.1}), 1, tank).value().area, 1.1 * 196, 0.02 * 196);
  EXPECT_NEAR(FilledShapeOf(Lattice(14, 14, {1, 0.9}), 1, tank).value().area, 0.9 * 196, 0.02 * 196);
}

TEST(FilledShapeOf, SprayHasMoreEdgeThanArea) {
  const auto shape = FilledShapeOf(Lattice(5, 5, {3, 3}), 1, kNoBounds).value();
  EXPECT_GT(shape.edge, 2 * shape.area);
}

TEST(FilledShapeOf, NoPointsHaveNoAreaAndLostOnesNone) {
  EXPECT_EQ(FilledShapeOf({}, 1, kNoBounds).value().area, 0);
  const std::vector<Vec2> strewn = {{0, 0}, {1e9, 1e9}}, nowhere = {{0, 0}, {std::nan(""), 0}};
  EXPECT_FALSE(FilledShapeOf(strewn, 1, kNoBounds).has_value());
  EXPECT_FALSE(FilledShapeOf(nowhere, 1, kNoBounds).has_value());
}

}  // namespace
}  // namespace sph
