// Where walls are, how deep a point is behind one, how they move, and which part of them is seen.
#include "particles/walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sph {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Wall Make(FluidSide fluid, double at) { return {"wall", fluid, at, 0, at, at}; }

std::vector<Wall> Tank() {
  return {{"left", FluidSide::kRight, -1, 0, -1, -1},
          {"right", FluidSide::kLeft, 3, 0, 3, 3},
          {"floor", FluidSide::kAbove, -2, 0, -2, -2}};
}

TEST(Wall, DepthIsTheDistanceBehindItAndNegativeInTheFluid) {
  EXPECT_EQ(Make(FluidSide::kLeft, 1).Depth({1.5, 9}), 0.5);
  EXPECT_EQ(Make(FluidSide::kRight, 1).Depth({1.5, 9}), -0.5);
  EXPECT_EQ(Make(FluidSide::kBelow, 1).Depth({9, 1.5}), 0.5);
  EXPECT_EQ(Make(FluidSide::kAbove, 1).Depth({9, 1.5}), -0.5);
}

TEST(Wall, ItsNormalIsTheDirectionInWhichDepthFallsFastest) {
  for (const FluidSide side : {FluidSide::kLeft, FluidSide::kRight, FluidSide::kBelow, FluidSide::kAbove}) {
    const Wall wall = Make(side, 1);
    const Vec2 inside{0.25, 0.5};
    EXPECT_EQ(Length(wall.Normal()), 1);
    EXPECT_EQ(wall.Depth(inside + 0.125 * wall.Normal()), wall.Depth(inside) - 0.125);
  }
}

TEST(Walls, StopAtTheEndOfTheirRange) {
  std::vector<Wall> walls = {{"dam", FluidSide::kLeft, 0, 1, -0.25, 0.95}};
  for (int k = 0; k < 8; ++k) MoveWalls(walls, 0.125);
  EXPECT_EQ(walls[0].at, 0.95);
  EXPECT_EQ(walls[0].velocity, 0);
  walls[0].velocity = -1;
  for (int k = 0; k < 20; ++k) MoveWalls(walls, 0.125);
  EXPECT_EQ(walls[0].at, -0.25);
  EXPECT_EQ(walls[0].velocity, 0);
}

TEST(Walls, MoveByTheirVelocityAndStayWithoutOne) {
  std::vector<Wall> walls = {{"moves", FluidSide::kLeft, 0.5, -0.25, -10, 10},
                             {"stays", FluidSide::kAbove, 7, 0, 0, 0}};
  MoveWalls(walls, 2);
  EXPECT_EQ(walls[0].at, 0);
  EXPECT_EQ(walls[0].velocity, -0.25);
  EXPECT_EQ(walls[1].at, 7) << "outside its range, but nobody moves it";
}

TEST(LegalRegion, IsWhatNoWallCovers) {
  EXPECT_EQ(LegalRegion(Tank()), (Box{-1, -2, 3, kFar}));
  EXPECT_EQ(LegalRegion({}), (Box{-kFar, -kFar, kFar, kFar}));
}

TEST(LegalRegion, IsBoundedByTheInnermostOfTwoWallsOnOneSide) {
  auto walls = Tank();
  walls.push_back({"dam", FluidSide::kLeft, 0.5, 0, 0.5, 0.5});
  EXPECT_EQ(LegalRegion(walls).x1, 0.5);
}

TEST(BoundingWalls, AreTheInnermostOnesWhateverTheirOrder) {
  auto walls = Tank();
  walls.push_back({"dam", FluidSide::kLeft, 0.5, 0, 0.5, 0.5});
  walls.push_back({"step", FluidSide::kAbove, -3, 0, -3, -3});
  for (int order = 0; order < 2; ++order) {
    const BoundingWalls bounding(walls);
    EXPECT_EQ(bounding.Of(FluidSide::kLeft)->name, "dam");
    EXPECT_EQ(bounding.Of(FluidSide::kRight)->name, "left");
    EXPECT_EQ(bounding.Of(FluidSide::kAbove)->name, "floor");
    EXPECT_EQ(bounding.Of(FluidSide::kBelow), nullptr);
    std::reverse(walls.begin(), walls.end());
  }
}

TEST(BoundingWalls, BeforeAreThoseThatBoundedThen) {
  auto walls = Tank();
  walls.push_back({"dam", FluidSide::kLeft, 2.5, -1, 0, 9});
  EXPECT_EQ(BoundingWalls(walls).Of(FluidSide::kLeft)->name, "dam");
  EXPECT_EQ(BoundingWalls(walls, 1).Of(FluidSide::kLeft)->name, "right");
  EXPECT_EQ(LegalRegion(walls, 1).x1, 3);
  EXPECT_EQ(LegalRegion(walls, 0.25).x1, 2.75);
}

TEST(BoundingWalls, OfTwoInOnePlaceAreTheOneThatComesAndThenTheFirstByName) {
  std::vector<Wall> walls = {
      {"a", FluidSide::kLeft, 1, 0, 1, 1}, {"c", FluidSide::kLeft, 1, -1, 0, 2}, {"b", FluidSide::kLeft, 1, -1, 0, 2}};
  do EXPECT_EQ(BoundingWalls(walls).Of(FluidSide::kLeft)->name, "b");
  while (std::next_permutation(walls.begin(), walls.end(), [](auto& a, auto& b) { return a.name < b.name; }));
}

TEST(TangentialVelocity, SwingsAboutItsMean) {
  const TangentialVelocity velocity{2, 3, 0.25, 0.5};
  EXPECT_DOUBLE_EQ(velocity.At(0), 2 + 3 * std::sin(0.5));
  EXPECT_DOUBLE_EQ(velocity.At(1), 2 + 3 * std::cos(0.5)) << "a quarter of a period later";
  EXPECT_NEAR(velocity.At(4), velocity.At(0), 1e-12);
}

TEST(FindWall, FindsByNameAndNothingElse) {
  auto walls = Tank();
  EXPECT_EQ(FindWall(walls, "right"), &walls[1]);
  EXPECT_EQ(FindWall(walls, "Right"), nullptr);
  EXPECT_EQ(FindWall(walls, ""), nullptr);
}

TEST(VisibleSegment, EndsWhereOtherWallsCoverItOrTheViewEnds) {
  const auto walls = Tank();
  const Box view{-10, -10, 10, 10};
  const auto floor = VisibleSegment(walls[2], walls, view);
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->a, (Vec2{-1, -2}));
  EXPECT_EQ(floor->b, (Vec2{3, -2}));
  const auto left = VisibleSegment(walls[0], walls, view);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->a, (Vec2{-1, -2}));
  EXPECT_EQ(left->b, (Vec2{-1, 10})) << "no ceiling: up to the view's end";
}

TEST(VisibleSegment, OfAWallBehindAnotherIsEmpty) {
  auto walls = Tank();
  walls.push_back({"dam", FluidSide::kLeft, 0.5, 0, 0.5, 0.5});
  const Box view{-10, -10, 10, 10};
  EXPECT_FALSE(VisibleSegment(walls[1], walls, view)) << "the right wall is behind the dam";
  EXPECT_TRUE(VisibleSegment(walls[3], walls, view));
}

TEST(VisibleSegment, OutsideTheViewIsEmpty) { EXPECT_FALSE(VisibleSegment(Tank()[2], Tank(), {5, -10, 10, 10})); }

TEST(PenetrationAfter, IsANumberHoweverStrongTheDamping) {
  // What is left of d'' = -c d' without a spring: d = v/c (1 - e^-ct).
  for (const double damping : {1.0, 1e3, 1e6, 1e12}) {
    WallParameters wall;
    wall.damping = damping;
    for (const double seconds : {1e-6, 1e-3, 1.0}) {
      const Penetration now = PenetrationAfter(wall, 2, seconds);
      EXPECT_NEAR(now.depth, -2 / damping * std::expm1(-damping * seconds), 1e-12) << damping << ", " << seconds;
      EXPECT_NEAR(now.speed, 2 * std::exp(-damping * seconds), 1e-9) << damping << ", " << seconds;
    }
  }
}

}  // namespace
}  // namespace sph
