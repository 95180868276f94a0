// Vectors and boxes of the plane.
#include "base/vec2.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

TEST(Vec2, LengthDoesNotOverflowWhereItsSquareWould) {
  EXPECT_DOUBLE_EQ(Length({3e200, 4e200}), 5e200);
  EXPECT_EQ(Length({0, 0}), 0);
}

TEST(Vec2, DotOfPerpendicularVectorsIsZero) { EXPECT_EQ(Dot({3, 4}, {-4, 3}), 0); }

TEST(Vec2, DifferencePointsFromTheSecondToTheFirst) { EXPECT_EQ((Vec2{3, 5} - Vec2{1, 1}), (Vec2{2, 4})); }

TEST(Box, CentreIsHalfWayBetweenTheCorners) {
  const Box box{-1, 2, 3, 10};
  EXPECT_EQ(box.Width(), 4);
  EXPECT_EQ(box.Height(), 8);
  EXPECT_EQ(box.Centre(), (Vec2{1, 6}));
}

}  // namespace
}  // namespace sph
