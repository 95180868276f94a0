#include "scenes/method_rules.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

/// Water in a box of 1 x 1 m, 0.1 m apart, with these walls.
Scene Water(const std::string& walls, const std::string& more = "") {
  return ParseScene(R"(title = "water"
solver = "delta"
fluid = { particles = 100, mass = 10.0, arrange = "lattice", region = { box = [0.0, 0.0, 1.0, 1.0] } }
equation_of_state.ideal_gas = { k = 100.0, rho0 = 1000.0 }
)" + more + "\n" + walls,
                    "water.toml");
}

const std::string kOfTank = R"(walls.kind = "mirror"
wall = [ { name = "l", at = 0.0, fluid = "right" }, { name = "r", at = 1.0, fluid = "left" },
         { name = "f", at = 0.0, fluid = "above" } )";
const std::string kTank = kOfTank + "]\n";
const std::string kFullBox = kOfTank + R"(, { name = "c", at = 1.0, fluid = "below" } ]
)";

TEST(MethodRules, VorticesWithoutViscosityGainNoEnergy) {
  SceneRequest request;
  request.scene = "taylor-green";
  request.particles = 225;
  request.settings = {"forces.viscosity=0"};
  const auto system = MakeSystem(LoadScene(request));
  const double before = Diagnose(*system).kinetic_energy;
  while (system->Time() < 1 && !system->Trouble()) {
    system->Step();
    ASSERT_LE(Diagnose(*system).kinetic_energy, 1.001 * before) << system->Time();  // 1.0002 as it starts
  }
  EXPECT_GE(system->Time(), 1);
}

TEST(MethodRules, ALiquidNeedsNoMethodAtAll) {
  const Scene scene = Water(kTank);
  EXPECT_EQ(scene.sph.delta.kernel, SmoothingKernel::kWendlandC2);
  EXPECT_DOUBLE_EQ(scene.sph.smoothing_length, 0.2) << "two spacings";
  EXPECT_TRUE(scene.base.adaptive_step);
  EXPECT_DOUBLE_EQ(scene.base.time_step, 0.25 * 0.2 / 10) << "c = 10 m/s";
  EXPECT_NO_THROW(MakeSystem(scene)->Step());
}

TEST(MethodRules, AGasHasAKernelOfItsOwn) {
  SceneRequest request;
  request.scene = "breathing-star";
  const Scene scene = LoadScene(request);
  EXPECT_EQ(scene.sph.delta.kernel, SmoothingKernel::kWendlandC4);
  EXPECT_NEAR(scene.sph.smoothing_length, 2.2 * Spacing(scene.base.fluid), 1e-12);
}

TEST(MethodRules, OnlyWhatHasNoSurfaceTakesTheGradientOfFourthOrder) {
  for (const auto& [walls, closed] : {std::pair{kTank, false}, std::pair{kFullBox, true}}) {
    const Scene scene = Water(walls);
    EXPECT_EQ(IsClosed(scene), closed) << walls;
    EXPECT_EQ(scene.sph.delta.sharp_gradient, closed);
    EXPECT_EQ(scene.sph.delta.viscous_form, closed ? ViscousForm::kLaplacian : ViscousForm::kStress);
  }
  EXPECT_TRUE(IsClosed(
      Water("periodic = { box = [0.0, 0.0, 1.0, 1.0], directions = \"both\" }\n", "method.smoothing_length = 0.1\n")));
  EXPECT_FALSE(IsClosed(
      Water("periodic = { box = [0.0, 0.0, 1.0, 2.0], directions = \"both\" }\n", "method.smoothing_length = 0.1\n")))
      << "half of it is empty";
}

TEST(MethodRules, WhatIsGivenStays) {
  const Scene scene = Water(kTank, R"(method.kernel = "quintic"
method.smoothing_length = 0.11
method.step = "fixed"
method.time_step = 0.002
method.sharp_gradient = "on"
method.viscous_form = "laplacian")");
  EXPECT_EQ(scene.sph.delta.kernel, SmoothingKernel::kQuintic);
  EXPECT_EQ(scene.sph.smoothing_length, 0.11);
  EXPECT_FALSE(scene.base.adaptive_step);
  EXPECT_EQ(scene.base.time_step, 0.002);
  EXPECT_TRUE(scene.sph.delta.sharp_gradient);
  EXPECT_EQ(scene.sph.delta.viscous_form, ViscousForm::kLaplacian);
}

TEST(MethodRules, AnotherSolverHasItsOwnSmoothingLengthUnlessItIsSet) {
  SceneRequest request;
  request.scene = "toy-star";
  const double of_paper = LoadScene(request).sph.smoothing_length;
  EXPECT_EQ(of_paper, 0.04) << "Table I";
  request.solver = "delta";
  const Scene delta = LoadScene(request);
  EXPECT_NEAR(delta.sph.smoothing_length, 2.2 * std::sqrt(delta.base.fluid.region.Area() / 1000), 1e-12);
  request.settings = {"method.smoothing_length=0.05"};
  EXPECT_EQ(LoadScene(request).sph.smoothing_length, 0.05);
}

TEST(MethodRules, ShippedScenesOfDeltaSayNothingOfTheMethodButPrecision) {
  for (const std::string& name : SceneNames()) {
    SceneRequest request;
    request.scene = name;
    const Scene scene = LoadScene(request);
    if (scene.solver != "delta") continue;
    Scene by_rule = scene;
    CompleteMethod(by_rule, {});
    const DeltaParameters usual = {}, &is = scene.sph.delta, &rule = by_rule.sph.delta;
    EXPECT_EQ(scene.sph.smoothing_length, by_rule.sph.smoothing_length) << name;
    EXPECT_EQ(scene.base.time_step, by_rule.base.time_step) << name;
    EXPECT_TRUE(is.kernel == rule.kernel && is.viscous_form == rule.viscous_form &&
                is.sharp_gradient == rule.sharp_gradient)
        << name;
    EXPECT_TRUE(is.diffusion == usual.diffusion && is.sound_damping == usual.sound_damping &&
                is.artificial_viscosity == usual.artificial_viscosity && is.shifting == usual.shifting &&
                is.tensile_control == usual.tensile_control)
        << name;
  }
}

}  // namespace
}  // namespace sph
