// Fluid that would start behind a wall, on its own twin, out of reach or held by nothing is refused, and what is said
// to fit does.
#include "scenes/placement_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

/// 40 particles 0.1 m apart for a box of 0.3 m below a ceiling.
std::string UnderACeiling() {
  std::string text = Changed("fluid = \"above\"\nrange = [-0.5, 0.5]", "fluid = \"below\"");
  text.replace(text.find("at = -0.1"), 9, "at = 0.3");
  text.replace(text.find("[0.0, 0.0, 1.0, 1.0]"), 20, "[0.0, 0.0, 0.3, 0.3]");
  return text.replace(text.find("particles = 100"), 15, "particles = 40\narrange = \"lattice\"\nspacing = 0.1");
}

TEST(PlacementChecks, RefuseALatticeThatGoesOnThroughACeilingAndSayWhatFits) {
  const std::string text = UnderACeiling();
  EXPECT_TRUE(Has(Refusal(text), {"FILE", "y = 1.35 m", "'floor' at 0.3 m", "fluid.particles = 9 would fit",
                                  "fluid.spacing = 0.04285 m"}));
  EXPECT_EQ(Refusal(text, {"fluid.particles=9"}), "accepted");
  EXPECT_EQ(Refusal(text, {"fluid.spacing=0.04285"}), "accepted");
  EXPECT_NE(Refusal(text, {"fluid.particles=10"}), "accepted");
  EXPECT_EQ(Refusal(text, {"wall.floor.at=1.4"}), "accepted") << "no wall is in the way";
  EXPECT_TRUE(Has(Refusal(text, {"fluid.arrange=perturbed"}), {"goes on above"}));
}

TEST(PlacementChecks, RefuseAJitterThatMayMoveParticlesBehindAWall) {
  const std::vector<std::string> settings = {"fluid.arrange=perturbed", "wall.floor.at=0", "fluid.jitter=0.07"};
  EXPECT_TRUE(Has(Refusal(kScene, settings), {"FILE", "fluid.jitter = 0.07", "'floor'", "0.05 m or less"}));
  EXPECT_EQ(Refusal(kScene, {settings[0], settings[1], "fluid.jitter=0.05"}), "accepted");
  EXPECT_EQ(Refusal(kScene, {"fluid.arrange=jittered", settings[1], settings[2]}), "accepted") << "to the right only";
}

TEST(PlacementChecks, RefuseARegionThatIsLargerThanThePeriod) {
  const auto with = [](const std::string& box, const std::string& directions) {
    return Refusal(kScene, {"method.smoothing_length=0.1", "periodic.box=" + box, "periodic.directions=" + directions});
  };
  EXPECT_TRUE(Has(with("[0,0,0.9,2]", "both"), {"FILE", "1 m wide", "every 0.9 m", "periodic.box"}));
  EXPECT_TRUE(Has(with("[0,0,2,0.9]", "y"), {"1 m high", "every 0.9 m"}));
  EXPECT_EQ(with("[0,0,0.9,2]", "y"), "accepted");
  EXPECT_EQ(with("[0.3,0,1.3,1]", "both"), "accepted") << "as large, and elsewhere";
  const std::vector<std::string> tall = {"method.smoothing_length=0.1", "periodic.box=[0,0,1,1]",
                                         "periodic.directions=both", "fluid.arrange=lattice", "fluid.spacing=0.11"};
  EXPECT_TRUE(Has(Refusal(kScene, tall), {"goes on above its region", "every 1 m", "fluid.particles = 81 would fit"}));
}

TEST(PlacementChecks, RefusePositionsThatCannotBeToldApart) {
  const auto at = [](const std::string& x, const std::string& x1, const char* precision) {
    return Refusal(kScene,
                   {"fluid.region.box=[" + x + ",0," + x1 + ",1]", std::string("method.precision=") + precision});
  };
  EXPECT_EQ(at("1e6", "1000001", "double"), "accepted");
  EXPECT_EQ(at("-1e5", "-99999", "float"), "accepted");
  EXPECT_TRUE(Has(at("1e7", "10000001", "double"), {"FILE", "1e+07 m from the origin", "spacing of 0.1 m", "6.71"}));
  EXPECT_TRUE(Has(at("-1e6", "-999999", "float"), {"1e+06 m", "in float", "8.388e+05 m or less"}));
}

TEST(PlacementChecks, RefuseWeightThatNoWallHolds) {
  const std::vector<std::string> at_rest = {"solver=delta", "walls.kind=mirror", "fluid.flow=hydrostatic"};
  const auto with = [&](const std::string& gravity, const std::string& flow, const std::string& at) {
    return Refusal(kScene,
                   {at_rest[0], at_rest[1], "fluid.flow=" + flow, "forces.gravity=" + gravity, "wall.floor.at=" + at});
  };
  EXPECT_EQ(with("[0,-9]", "hydrostatic", "0"), "accepted");
  EXPECT_EQ(with("[0,0]", "hydrostatic", "0"), "accepted");
  EXPECT_TRUE(Has(with("[0,9]", "hydrostatic", "0"), {"FILE", "against its top", "no wall", "at 1 m"}));
  EXPECT_TRUE(Has(with("[-1,-9]", "hydrostatic", "0"), {"against its left", "at 0 m"}));
  EXPECT_TRUE(Has(with("[1,-9]", "hydrostatic", "0"), {"against its right", "at 1 m"}));
  EXPECT_TRUE(Has(with("[0,-9]", "hydrostatic", "-0.5"), {"against its bottom"})) << "it would fall";
  EXPECT_TRUE(Has(with("[1,-9]", "standing-wave", "0"), {"'standing-wave'", "straight down"}));
  EXPECT_EQ(with("[1,-9]", "rest", "0"), "accepted");
}

/// A tank of water of 0.9 m between walls on all sides but that which gravity points away from.
std::string Tank(const std::string& gravity, const std::string& wall) {
  return R"(title = "Tank"
solver = "delta"
[fluid]
particles = 360
mass = 2.5
region = { box = [0.0, 0.0, 1.0, 0.9] }
arrange = "lattice"
flow = "hydrostatic"
masses = "graded"
[equation_of_state]
ideal_gas = { k = 360.0, rho0 = 1000.0 }
[method]
kernel = "quintic"
smoothing_length = 0.047
time_step = 0.0016
[forces]
gravity = )" +
         gravity + R"(
[walls]
kind = "mirror"
[[wall]]
name = "l"
at = 0.0
fluid = "right"
[[wall]]
name = "r"
at = 1.0
fluid = "left"
)" + wall;
}
const char* const kFloor = "[[wall]]\nname = \"f\"\nat = 0.0\nfluid = \"above\"\n";
const char* const kCeiling = "[[wall]]\nname = \"c\"\nat = 0.9\nfluid = \"below\"\n";

double KineticEnergy(const std::string& text) {
  const auto system = MakeSystem(SceneFrom(text));
  for (int k = 0; k < 60; ++k) system->Step();
  return Diagnose(*system).kinetic_energy;
}

TEST(HydrostaticStart, IsAtRestUpsideDownAsItIsUpright) {
  const double upright = KineticEnergy(Tank("[0.0, -1.0]", kFloor));
  EXPECT_LT(upright, 1e-6) << "of 365 J/m that it weighs";
  EXPECT_NEAR(KineticEnergy(Tank("[0.0, 1.0]", kCeiling)), upright, 1e-3 * upright);
}

TEST(HydrostaticStart, InAClosedBoxHasNoPressureInTheCornerThatGravityPointsAwayFrom) {
  const auto system = MakeSystem(SceneFrom(Tank("[0.5, 0.8]", std::string(kFloor) + kCeiling)));
  EXPECT_NEAR(system->FlowAt({0, 0}).pressure, 0, 1e-12);
  EXPECT_NEAR(system->FlowAt({1, 0}).pressure, 500, 1e-9);
  EXPECT_NEAR(system->FlowAt({1, 0.9}).pressure, 1220, 1e-9);
  double lowest = 1e300;
  for (const double pressure : system->Pressure()) lowest = std::min(lowest, pressure);
  EXPECT_GT(lowest, 0);
}

TEST(HydrostaticStart, FarAwayIsAtRestAsItIsAtTheOrigin) {
  std::string far = Tank("[0.0, -1.0]", kFloor);
  far.replace(far.find("[0.0, 0.0, 1.0, 0.9]"), 20, "[1e6, 1e6, 1000001.0, 1000000.9]");
  for (const auto& [from, to] : {std::pair{"at = 0.0\nfluid = \"right\"", "at = 1e6\nfluid = \"right\""},
                                 {"at = 1.0", "at = 1000001.0"},
                                 {"at = 0.0\nfluid = \"above\"", "at = 1e6\nfluid = \"above\""}}) {
    far.replace(far.find(from), std::string(from).size(), to);
  }
  const double here = KineticEnergy(Tank("[0.0, -1.0]", kFloor));
  EXPECT_NEAR(KineticEnergy(far), here, 0.01 * here);
}

}  // namespace
}  // namespace sph
