// The gauge in a wall: what it shows of water at rest, and where there is none.
#include "lab/wall_probe.hpp"

#include <gtest/gtest.h>

#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

std::unique_ptr<ParticleSystemSPH> StillWater() {
  SceneRequest request;
  request.scene = "still-water";
  return MakeSystem(LoadScene(request));
}

TEST(WallProbe, ShowsTheWeightOfWaterAtRest) {
  const auto water = StillWater();
  for (const double y : {0.1, 0.45, 0.7}) {
    // Within 0.1 % of rho g H: the pressure is linear, and the lattice even.
    EXPECT_NEAR(PressureAtWall(*water, {2, y}), 1000 * (0.9 - y), 0.9) << y;
    EXPECT_NEAR(PressureAtWall(*water, {0, y}), PressureAtWall(*water, {2, y}), 1e-6) << "either wall";
  }
}

TEST(WallProbe, ShowsNothingInTheAirAndLessThanTheWaterWhereItIsHalfDry) {
  const auto water = StillWater();
  EXPECT_EQ(PressureAtWall(*water, {2, 1.2}), 0);
  // Half a support above the surface a few particles are seen, with their pressures of a spacing's depth and less.
  const double above = PressureAtWall(*water, {2, 0.93});
  EXPECT_GT(above, 0);
  EXPECT_LT(above, 10);
}

}  // namespace
}  // namespace sph
