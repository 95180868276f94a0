// Resolution, defaults, and what follows from other parameters.
#include "scenes/build.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

Scene Dam(WallScaling scaling, std::size_t particles) {
  Scene scene = LoadScene({});
  scene.wall_scaling = scaling;
  ScaleToParticles(scene, particles);
  return scene;
}

TEST(ScaleToParticles, ChangesWhatFollowsFromTheNumber) {
  const Scene start = LoadScene({});
  const Scene scene = Dam(WallScaling::kDerived, 4 * 600);  // f = 4, its root 2: exact in binary
  EXPECT_EQ(scene.base.fluid.particles, 2400u);
  EXPECT_EQ(scene.base.drop.particles, 4 * start.base.drop.particles);
  EXPECT_EQ(scene.base.particle_mass, start.base.particle_mass / 4);
  EXPECT_EQ(scene.sph.smoothing_length, start.sph.smoothing_length / 2);
  EXPECT_EQ(scene.base.time_step, start.base.time_step / 2);
  EXPECT_EQ(scene.base.wall.stiffness, start.base.wall.stiffness * 4);
  EXPECT_EQ(scene.base.wall.damping, start.base.wall.damping * 2);
}

TEST(ScaleToParticles, KeepsTheFluidAndItsSurroundings) {
  const Scene start = LoadScene({});
  const Scene scene = Dam(WallScaling::kDerived, 1111);
  EXPECT_DOUBLE_EQ(scene.base.particle_mass * 1111, start.base.particle_mass * 600);
  EXPECT_DOUBLE_EQ(scene.sph.smoothing_length / Spacing(scene.base.fluid),
                   start.sph.smoothing_length / Spacing(start.base.fluid));
  EXPECT_EQ(scene.base.fluid.region.box, start.base.fluid.region.box);
  EXPECT_EQ(scene.base.gravity, start.base.gravity);
  EXPECT_EQ(scene.base.motion_damping, start.base.motion_damping);
}

TEST(ScaleToParticles, ScalesLatticeJitterAndLimitOfTheTutorialsScene) {
  SceneRequest request;
  request.scene = "mueller";
  const Scene start = LoadScene(request);
  request.particles = 2000;
  const Scene scene = LoadScene(request);
  EXPECT_EQ(scene.base.fluid.spacing, start.base.fluid.spacing / 2);
  EXPECT_EQ(scene.base.fluid.jitter, start.base.fluid.jitter / 2);
  EXPECT_EQ(scene.base.particle_limit, 4 * start.base.particle_limit);
  EXPECT_EQ(scene.base.drop.particles, 1000u);
}

/// g H/(K dx^2), the depth in spacings to which a column of height H presses its lowest layer into a floor (SEEDS).
double DepthInSpacings(const Scene& scene) {
  const double dx = Spacing(scene.base.fluid);
  return 9.8 * 0.95 / (scene.base.wall.stiffness * dx * dx);
}

TEST(ScaleToParticles, KeepsAViscousFluidWithinItsLimit) {
  // Explicit viscosity needs dt in proportion to dx^2; with dx alone this breaks down within 0.2 s.
  SceneRequest request;
  request.scene = "mueller";
  request.particles = 18'000;
  const auto system = MakeSystem(LoadScene(request));
  while (system->Time() < 0.02 && !system->Trouble()) system->Step();
  EXPECT_FALSE(system->Trouble()) << system->Trouble()->Message();
}

RC_GTEST_PROP(ScaleToParticles, KeepsDepthInSpacingsAndTheWallsLimitOfTheStep, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(10, 1000000);
  const Scene start = LoadScene({});
  const Scene derived = Dam(WallScaling::kDerived, n);
  const Scene published = Dam(WallScaling::kPublished, n);
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12 * std::abs(b); };  // a few roundings
  const double f = static_cast<double>(n) / 600;
  RC_ASSERT(near(DepthInSpacings(derived), DepthInSpacings(start)));
  RC_ASSERT(near(DepthInSpacings(published), f * DepthInSpacings(start)));
  const auto spring_step = [](const Scene& s) { return std::sqrt(s.base.wall.stiffness) * s.base.time_step; };
  const auto damping_step = [](const Scene& s) { return s.base.wall.damping * s.base.time_step; };
  RC_ASSERT(near(spring_step(derived), spring_step(start)));
  RC_ASSERT(near(damping_step(derived), damping_step(start)));
  RC_ASSERT(published.base.wall.stiffness == start.base.wall.stiffness);
  RC_ASSERT(published.base.wall.damping == start.base.wall.damping);
}

TEST(CompleteParameters, DerivesTheStarsForceFromMassRadiusAndGas) {
  Scene scene = SceneFrom(kScene, {"equation_of_state.polytrope.k=0.3", "forces.star={mass=5,radius=0.5}"});
  EXPECT_DOUBLE_EQ(CompleteParameters(scene).central_force, 8 * 0.3 * 5 / (M_PI * 0.0625));
  ASSERT_TRUE(StarOf(scene));
  EXPECT_EQ(StarOf(scene)->mass, 5);
  scene.star.reset();
  EXPECT_FALSE(StarOf(scene));
  EXPECT_EQ(CompleteParameters(scene).central_force, 0);
}

TEST(CompleteParameters, GivesEverySceneABlockThatDrops) {
  const auto system = MakeSystem(SceneFrom(kScene));  // a floor, no other walls, no [drop]
  EXPECT_EQ(system->DropBlock(), "");
  EXPECT_EQ(system->State().Size(), 125u) << "a quarter of the fluid";
}

TEST(CompleteParameters, FillsInTheBlocksSpacingAndNumber) {
  const Parameters p = CompleteParameters(SceneFrom(kScene, {"drop.box=[0,2,0.5,3]"}));
  EXPECT_DOUBLE_EQ(p.drop.spacing, 0.1) << "that of the fluid";
  EXPECT_EQ(p.drop.particles, 50u) << "as many as its box holds";
}

TEST(MakeSystem, HasTheMassAskedForWhateverNumberFits) {
  const auto mass = [](const Scene& scene) {
    const auto system = MakeSystem(scene);
    double sum = 0;
    for (const double m : system->State().mass) sum += m;
    return sum;
  };
  const std::string disk = "region = { disk = { centre = [0.5, 0.5], radius = 0.4 } }";
  for (const std::string arrange : {"lattice", "jittered", "perturbed", "hexagonal", "relaxed", "random"}) {
    for (const std::string& text : {kScene, Changed("region = { box = [0.0, 0.0, 1.0, 1.0] }", disk)}) {
      const Scene scene = SceneFrom(text, {"fluid.particles=97", "fluid.arrange=" + arrange});
      EXPECT_NEAR(mass(scene), 97 * 0.01, 1e-12) << arrange;
    }
  }
  std::string text = Changed("region = { box = [0.0, 0.0, 1.0, 1.0] }", disk);
  text.replace(text.find("tait = { k = 0.5, rho0 = 1.0 }"), 30, "polytrope = { k = 0.1 }");
  const Scene star = SceneFrom(text, {"solver=delta", "fluid.arrange=hexagonal", "fluid.masses=graded",
                                      "fluid.flow=star", "fluid.particles=97"});
  EXPECT_NEAR(mass(star), 97 * 0.01, 1e-12) << "graded";
}

TEST(DescribePlacement, SaysWhatWasPlacedAndWhatWouldFit) {
  const Scene fits = SceneFrom(kScene, {"fluid.arrange=lattice"});
  EXPECT_EQ(DescribePlacement(fits), "placed 100 particles (10 x 10)");
  const Scene does_not = SceneFrom(kScene, {"fluid.arrange=lattice", "fluid.particles=107"});
  EXPECT_TRUE(Has(DescribePlacement(does_not), {"placed 110 particles", "of 107 asked for", "box exactly: 100, 121"}));
  const Scene hexagons = SceneFrom(
      Changed("region = { box = [0.0, 0.0, 1.0, 1.0] }", "region = { disk = { centre = [0.5, 0.5], radius = 0.4 } }"),
      {"fluid.arrange=hexagonal", "fluid.particles=2000"});
  EXPECT_TRUE(Has(DescribePlacement(hexagons), {"placed 1993 particles of 2000", "disk exactly: 1993, 2053"}));
}

TEST(CompleteParameters, LeavesWhatTheSceneSays) {
  const Scene scene = SceneFrom(kScene, {"fluid.limit=123", "forces.central=7"});
  EXPECT_EQ(CompleteParameters(scene).particle_limit, 123u);
  EXPECT_EQ(CompleteParameters(scene).central_force, 7);
}

TEST(MakeSystem, StartsWithTheScenesParticlesSolverAndTimeZero) {
  const auto paper = MakeSystem(SceneFrom(kScene));
  EXPECT_EQ(paper->State().Size(), 100u);
  EXPECT_EQ(paper->Time(), 0);
  EXPECT_EQ(paper->KernelName(), "cubic spline");
  EXPECT_NE(MakeSystem(SceneFrom(kScene, {"solver=mueller"}))->KernelName(), "cubic spline");
}

TEST(InitialView, IsTheOneThatTheSceneGives) {
  EXPECT_EQ(InitialView(SceneFrom(kScene, {"view=[1,2,3,4]"})), (Box{1, 2, 3, 4}));
}

TEST(InitialView, ShowsFluidAndWallsWhereverTheyGo) {
  const Box view = InitialView(SceneFrom(kScene));
  EXPECT_LT(view.y0, -0.5) << "the floor can go down to -0.5";
  EXPECT_LT(view.x0, 0);
  EXPECT_GT(view.x1, 1);
  EXPECT_GT(view.y1, 1);
}

TEST(MakeSystem, RefusesASceneThatCannotStart) {
  SceneRequest request;
  request.scene = "rotating-square";
  request.particles = 196;
  request.settings = {"fluid.masses=graded", "fluid.flow_speed=1e6"};  // the pressure is far below zero
  try {
    MakeSystem(LoadScene(request));
    FAIL() << "accepted";
  } catch (const UsageError& error) {
    const std::string message = error.what();
    for (const char* part : {"rotating-square", "cannot start", "particle 0", "its mass is not a number above 0"}) {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace sph
