// What contradicts itself across keys is refused before anything runs.
#include "scenes/scene_checks.hpp"

#include <gtest/gtest.h>

#include "scenes/scene_file.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

TEST(SceneChecks, RefuseAFluidBehindAWallWithBothRectangles) {
  EXPECT_TRUE(Has(Refusal(Changed("at = -0.1", "at = 0.3")), {"FILE", "behind a wall", "[0, 0, 1, 1]", "0.3"}));
  EXPECT_EQ(Refusal(Changed("at = -0.1", "at = 0.0")), "accepted") << "fluid may touch the wall";
}

TEST(SceneChecks, RefuseADiskThatReachesBehindAWall) {
  const std::string disk = "region = { disk = { centre = [0.5, 0.5], radius = 0.7 } }";
  EXPECT_TRUE(Has(Refusal(Changed("region = { box = [0.0, 0.0, 1.0, 1.0] }", disk)), {"behind a wall"}));
}

TEST(SceneChecks, RefuseAFluidWithoutARegionOrEquationOfState) {
  EXPECT_TRUE(Has(Refusal(Changed("region = { box = [0.0, 0.0, 1.0, 1.0] }\n", "")), {"FILE", "fluid.region.box"}));
  EXPECT_TRUE(Has(Refusal(Changed("tait = { k = 0.5, rho0 = 1.0 }\n", "")), {"FILE", "equation_of_state.polytrope"}));
  EXPECT_TRUE(Has(Refusal(Changed(", rho0 = 1.0", "")), {"FILE", "tait = { k, rho0 }"}));
}

TEST(SceneChecks, RefuseHalfAStarAndAStarOfAnotherGas) {
  EXPECT_TRUE(
      Has(Refusal(kScene, {"equation_of_state.polytrope.k=1", "forces.star.mass=1"}), {"both mass and radius"}));
  EXPECT_TRUE(
      Has(Refusal(kScene, {"forces.star={mass=1,radius=1}"}), {"forces.star goes with equation_of_state.polytrope"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"reference=static-star"}), {"needs forces.star"}));
}

TEST(SceneChecks, RefuseAPeriodicBoxWithoutDirectionsAndDirectionsWithoutABox) {
  EXPECT_TRUE(Has(Refusal(kScene, {"periodic.box=[0,0,2,2]"}), {"FILE", "periodic takes both", "directions"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"periodic.directions=x"}), {"FILE", "periodic takes both", "box"}));
  EXPECT_EQ(Refusal(kScene, {"periodic.box=[0,0,2,2]", "periodic.directions=both"}), "accepted");
  EXPECT_TRUE(Has(Refusal(kScene, {"periodic.box=[0,0,2,2]", "periodic.directions=z"}), {"'z'", "x", "both"}));
}

TEST(SceneChecks, RefuseAPeriodOfAFewSmoothingLengthsInADirectionThatRepeats) {
  const auto with = [](const std::string& box, const std::string& directions) {
    return Refusal(kScene, {"periodic.box=" + box, "periodic.directions=" + directions});
  };
  EXPECT_TRUE(Has(with("[0,0,1,2]", "x"), {"FILE", "periodic.box = [0, 0, 1, 2]", "too small", "1.06"}));
  EXPECT_TRUE(Has(with("[0,0,1,2]", "both"), {"too small"}));
  EXPECT_EQ(with("[0,0,1,2]", "y"), "accepted");
}

TEST(SceneChecks, RefuseFlowsKernelsAndStartsThatAreNone) {
  EXPECT_TRUE(Has(Refusal(kScene, {"fluid.flow=taylor-gren"}), {"fluid.flow", "'taylor-gren'", "taylor-green"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"fluid.arrange=hexagon"}), {"fluid.arrange", "hexagonal"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"method.kernel=wendland"}), {"method.kernel", "wendland-c2", "wendland-c4"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"fluid.flow_speed=0"}), {"fluid.flow_speed", "> 0"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"method.diffusion=2"}), {"method.diffusion"}));
}

TEST(SceneChecks, RefuseHalfASettlingAndOneThatNeverEnds) {
  EXPECT_TRUE(Has(Refusal(kScene, {"fluid.settle.time=1"}), {"FILE", "fluid.settle takes both time and damping"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"fluid.settle={time=1e9,damping=1}"}), {"FILE", "more than a million steps"}));
}

TEST(SceneChecks, RefuseASlidingWallToWhichNothingSticks) {
  const std::string slides = "wall.floor.tangential_velocity=2", mirror = "walls.kind=mirror", delta = "solver=delta";
  EXPECT_TRUE(Has(Refusal(kScene, {slides}), {"FILE", "'floor'", "tangential_velocity", "walls.kind = 'mirror'"}));
  EXPECT_TRUE(Has(Refusal(kScene, {delta, mirror, slides}), {"slip = 'no-slip'"}));
  EXPECT_EQ(Refusal(kScene, {delta, mirror, "walls.slip=no-slip", slides}), "accepted");
  EXPECT_EQ(Refusal(kScene, {delta, "walls.kind=particles", "walls.slip=no-slip", slides}), "accepted");
  EXPECT_EQ(Refusal(kScene, {delta, mirror, "wall.floor.slip=no-slip", slides}), "accepted");
  EXPECT_TRUE(Has(Refusal(kScene, {delta, mirror, "walls.slip=no-slip", "wall.floor.slip=free-slip", slides}),
                  {"'floor'", "slip = 'no-slip'"}));
}

TEST(SceneChecks, RefuseToStickToWallsThatTheFluidDoesNotSee) {
  EXPECT_TRUE(Has(Refusal(kScene, {"walls.slip=no-slip"}), {"FILE: walls.slip", "'mirror' or 'particles'"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"wall.floor.slip=no-slip"}), {"wall 'floor'", "'mirror' or 'particles'"}));
}

TEST(SceneChecks, RefuseWhatTheSolverDoesNotUse) {
  EXPECT_TRUE(Has(Refusal(kScene, {"method.kernel=quintic"}), {"--set", "method.kernel", "solver delta", "'paper'"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"forces.viscosity=1"}), {"forces.viscosity", "mueller or delta"}));
  EXPECT_EQ(Refusal(kScene, {"method.kernel=quintic", "solver=delta"}), "accepted") << "in any order";
  EXPECT_TRUE(Has(Refusal(Changed("time_step =", "diffusion = 0.1\ntime_step =")), {"FILE:", "method.diffusion"}));
}

TEST(SceneChecks, RefuseWallsThatTheSolverDoesNotSee) {
  for (const std::string kind : {"mirror", "particles"}) {
    EXPECT_TRUE(Has(Refusal(kScene, {"walls.kind=" + kind}), {"FILE", "'" + kind + "'", "solver = 'delta'"}));
  }
}

TEST(SceneChecks, RefuseMoreLayersOfWallParticlesThanAnybodyNeeds) {
  const auto with = [](const std::string& h) {
    return Refusal(kScene, {"solver=delta", "walls.kind=particles", "method.smoothing_length=" + h});
  };
  EXPECT_EQ(with("1"), "accepted");  // spacings of 0.1 m, a support of two metres
  EXPECT_TRUE(Has(with("1.01"), {"FILE", "20 spacings", "20.2", "<= 1 m"}));
}

TEST(SceneChecks, RefuseABoundaryLayerWhereNothingSlipsAlongAMirror) {
  const std::string layer = "walls.layer_viscosity=1e-6";
  EXPECT_TRUE(Has(Refusal(kScene, {layer}), {"FILE", "walls.kind = 'mirror'"}));
  EXPECT_TRUE(
      Has(Refusal(kScene, {"solver=delta", "walls.kind=mirror", "walls.slip=no-slip", layer}), {"'free-slip'"}));
  EXPECT_EQ(SceneFrom(kScene, {"solver=delta", "walls.kind=mirror", layer}).base.wall.layer_viscosity, 1e-6);
}

TEST(SceneChecks, RefuseFormsAndAmountsThatAreNone) {
  EXPECT_TRUE(Has(Refusal(kScene, {"method.viscous_form=stres"}), {"method.viscous_form", "laplacian", "stress"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"method.sound_damping=2"}), {"method.sound_damping"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"walls.layer_viscosity=-1"}), {"walls.layer_viscosity", ">= 0"}));
}

TEST(SceneChecks, RefuseControlsOfWhatIsNotThere) {
  EXPECT_TRUE(
      Has(Refusal(kScene, {"arrows={wall='flor',speed=1}"}), {"arrows.wall", "'flor'", "Did you mean 'floor'?"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"arrows.wall=floor"}), {"needs arrows.speed"}));
  const auto with = [](const std::string& action) {
    return Refusal(kScene + "[[key]]\npress = \"d\"\ndo = [ " + action + " ]\n");
  };
  EXPECT_TRUE(Has(with("{ move_wall = \"dam\", to = 0 }"), {"key 'd'", "'dam'"}));
  EXPECT_TRUE(Has(with("{ set = \"forces.damp\", to = 0 }"), {"'forces.damp'", "is not a scene key"}));
  EXPECT_TRUE(Has(with("{ set = \"fluid.mass\", to = 1 }"), {"'fluid.mass'", "cannot be set while the scene runs"}));
  EXPECT_TRUE(Has(with("{ set = \"forces.damping\", to = -1 }"), {"forces.damping = -1", ">= 0"}));
}

TEST(SceneChecks, RefuseAControlOfWhatTheSolverDoesNotUse) {
  const std::string text = kScene + "[[key]]\npress = \"d\"\ndo = [ { set = \"method.diffusion\", to = 0.2 } ]\n";
  EXPECT_TRUE(Has(Refusal(text), {"FILE: key 'd'", "method.diffusion", "solver delta", "'paper'"}));
}

TEST(SceneChecks, RefuseAKeyThatWouldLeaveHalfAnEquationOfState) {
  const std::string text =
      kScene + "[[key]]\npress = \"d\"\ndo = [ { set = \"equation_of_state.ideal_gas.k\", to = 2 } ]\n";
  EXPECT_TRUE(Has(Refusal(text), {"key 'd'", "ideal_gas = { k, rho0 }"}));
}

TEST(SceneChecks, RefuseALatticeThatIsTooFineToBeTriedSiteBySite) {
  const std::string disk = "region = { disk = { centre = [0.5, 0.5], radius = 0.4 } }";
  const std::string scene = Changed("region = { box = [0.0, 0.0, 1.0, 1.0] }", disk);
  EXPECT_TRUE(Has(Refusal(scene, {"fluid.arrange=lattice", "fluid.spacing=1e-9"}), {"fluid.spacing = 1e-09", "sites"}));
  EXPECT_EQ(Refusal(scene, {"fluid.arrange=lattice", "fluid.spacing=0.01"}), "accepted");
  EXPECT_TRUE(Has(Refusal(kScene, {"fluid.arrange=hexagonal", "fluid.spacing=1e-9"}), {"fluid.spacing", "sites"}));
}

}  // namespace
}  // namespace sph
