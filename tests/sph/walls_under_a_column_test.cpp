// How deep a column presses its lowest layer into a penalty wall: K depth = g H/dx, the reason why IV-D's walls fail
// for many particles at a constant K.
#include <gtest/gtest.h>

#include "sph/given_system.hpp"

namespace sph {
namespace {

constexpr double kSpacing = 0.05;
constexpr double kStiffness = 20000;
constexpr double kGravity = 9.8;

/// Depth of the lowest particle of a column of `layers`, one particle wide, when it has come to rest [m].
double RestingDepth(int layers, double stiffness, Integration integration) {
  Parameters base = NoForces();
  base.time_step = 5e-4;
  base.integration = integration;
  base.gravity = {0, -kGravity};
  base.motion_damping = 20;
  base.wall.stiffness = stiffness;
  base.wall.damping = 256;
  base.walls = {{"floor", FluidSide::kAbove, 0, 0, 0, 0}};
  Cloud column;
  for (int k = 0; k < layers; ++k) {
    column.x.push_back(0);
    column.y.push_back(kSpacing * k);
  }
  column.vx = column.vy = column.x;
  column.mass.assign(column.Size(), kSpacing * kSpacing);
  // A gas so stiff that the column keeps its layers apart.
  GivenSystem system(base, {1.3 * kSpacing, Polytrope{200}, 0, false}, column);
  for (int k = 0; k < 8000; ++k) system.Step();
  EXPECT_FALSE(system.Trouble());
  double depth = 0;
  int inside = 0;
  for (const double y : system.State().y) {
    depth = std::max(depth, -y);
    inside += y < 0 ? 1 : 0;
  }
  EXPECT_EQ(inside, 1) << "one layer carries the column";
  return depth;
}

TEST(WallsUnderAColumn, TheLowestLayerCarriesItAll) {
  // At rest the forces on the whole column balance, whatever is between its particles: m K depth = n m g, and n = H/dx.
  // What is left of the motion after 4 s at a damping of 20/s is round-off.
  for (const int layers : {1, 2, 10}) {
    const double expected = kGravity * layers / kStiffness;
    EXPECT_NEAR(RestingDepth(layers, kStiffness, Integration::kLeapFrog), expected, 1e-6 * expected) << layers;
  }
}

TEST(WallsUnderAColumn, PublishedFormsOfTheStepRestAtTheSameDepth) {
  for (const Integration integration : {Integration::kLeapFrogPublished, Integration::kSymplecticEuler}) {
    EXPECT_NEAR(RestingDepth(5, kStiffness, integration), kGravity * 5 / kStiffness, 1e-6 * kGravity * 5 / kStiffness);
  }
}

TEST(WallsUnderAColumn, AStifferWallIsEnteredLess) {
  EXPECT_NEAR(RestingDepth(5, 4 * kStiffness, Integration::kLeapFrog), kGravity * 5 / (4 * kStiffness),
              1e-6 * kGravity * 5 / (4 * kStiffness));
}

}  // namespace
}  // namespace sph
