// The scenes from the two documents carry every number as published.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

Scene Load(const std::string& name) {
  SceneRequest request;
  request.scene = name;
  return LoadScene(request);
}

const Wall& WallNamed(const Scene& scene, const std::string& name) {
  for (const Wall& wall : scene.base.walls) {
    if (wall.name == name) return wall;
  }
  throw std::runtime_error("no wall " + name);
}

TEST(TableOne, ToyStar) {
  const Scene scene = Load("toy-star");
  EXPECT_EQ(scene.base.fluid.particles, 1000u);
  EXPECT_EQ(scene.sph.smoothing_length, 0.04);
  EXPECT_EQ(scene.base.time_step, 0.004);
  EXPECT_EQ(scene.base.motion_damping, 0.5);
  EXPECT_EQ(std::get<Polytrope>(scene.sph.equation_of_state).k, 0.1);
  EXPECT_EQ(scene.base.particle_mass, 0.002);
  EXPECT_EQ(scene.base.wall.stiffness, 20000);
  EXPECT_EQ(scene.base.wall.damping, 256);
  EXPECT_EQ(scene.base.wall.kind, WallKind::kPenalty);
  // "Acceleration of gravity 8Mk/(pi R^4)" is the lambda of b = -lambda x (VI-C).
  EXPECT_DOUBLE_EQ(CompleteParameters(scene).central_force, 8 * 2.0 * 0.1 / (std::numbers::pi * std::pow(0.75, 4)));
  EXPECT_EQ(scene.base.gravity, Vec2{});
}

TEST(TableOne, StarsSurroundings) {
  const Scene scene = Load("toy-star");
  EXPECT_EQ(scene.star->mass, 2.0);  // VI-C: M = 2 kg, R = 0.75 m, random in the disk, masses M/N, walls at +-0.95
  EXPECT_EQ(scene.star->radius, 0.75);
  EXPECT_DOUBLE_EQ(scene.base.particle_mass * 1000, scene.star->mass);
  EXPECT_EQ(scene.base.fluid.arrange, Arrangement::kRandom);
  EXPECT_EQ(scene.base.fluid.region.radius, 0.75);
  EXPECT_EQ(scene.base.fluid.region.centre, Vec2{});
  EXPECT_EQ(LegalRegion(scene.base.walls), (Box{-0.95, -0.95, 0.95, 0.95}));
  EXPECT_EQ(scene.reference, Reference::kStaticStar);
  EXPECT_EQ(scene.solver, "paper");
  EXPECT_EQ(scene.base.integration, Integration::kLeapFrog);
}

TEST(TableOne, SmoothingLengthFollowsTheNumberAsPublished) {
  for (const std::size_t n : {250, 3000, 10000}) {
    SceneRequest request;
    request.scene = "toy-star";
    request.particles = n;
    const Scene scene = LoadScene(request);
    EXPECT_DOUBLE_EQ(scene.sph.smoothing_length, 0.04 / std::sqrt(static_cast<double>(n) / 1000));
    EXPECT_DOUBLE_EQ(scene.base.particle_mass, 2.0 / static_cast<double>(n));
  }
}

TEST(TableTwo, BreakingDam) {
  const Scene scene = Load("dam-break");
  EXPECT_EQ(scene.base.fluid.particles, 600u);
  EXPECT_EQ(scene.sph.smoothing_length, 0.068);
  EXPECT_EQ(scene.base.time_step, 0.004);
  EXPECT_EQ(scene.base.gravity, (Vec2{0, -9.8}));
  EXPECT_EQ(scene.base.motion_damping, 8) << "1 (8): 8 until the dam breaks";
  const Tait& tait = std::get<Tait>(scene.sph.equation_of_state);
  EXPECT_EQ(tait.k, 0.5);
  EXPECT_EQ(tait.rho0, 2.861);
  EXPECT_EQ(tait.exponent, 7) << "eq. 23";
  EXPECT_EQ(scene.base.particle_mass, 0.0033);
  EXPECT_EQ(scene.base.wall.stiffness, 20000) << "VII: the boundary constants are those of the toy star";
  EXPECT_EQ(scene.base.wall.damping, 256);
  EXPECT_EQ(scene.solver, "paper");
}

TEST(TableTwo, DamsSurroundingsAndItsBreaking) {
  const Scene scene = Load("dam-break");
  const Box legal = LegalRegion(scene.base.walls);
  EXPECT_EQ(legal, (Box{-0.95, -0.95, -0.35, 0.95}));
  // "the bottom half of the initially legal area", at random
  EXPECT_EQ(scene.base.fluid.region.box, (Box{legal.x0, legal.y0, legal.x1, legal.Centre().y}));
  EXPECT_EQ(scene.base.fluid.arrange, Arrangement::kRandom);
  ASSERT_EQ(scene.controls.size(), 1u);
  EXPECT_EQ(scene.controls[0].press, "d");
  ASSERT_EQ(scene.controls[0].actions.size(), 2u);
  const auto move = std::get<MoveWallAction>(scene.controls[0].actions[0]);
  EXPECT_EQ(WallNamed(scene, move.wall).at, -0.35);
  EXPECT_EQ(move.to, 0.95);
  const auto set = std::get<SetAction>(scene.controls[0].actions[1]);
  EXPECT_EQ(set.key, "forces.damping");
  EXPECT_EQ(set.to, 1);
}

/// What both forms of the tutorial's scene have in common; `metres` is the length of one of its pixels.
void ExpectTheTutorialsNumbers(const Scene& scene, double metres) {
  EXPECT_EQ(scene.solver, "mueller");
  EXPECT_EQ(scene.base.fluid.particles, 500u);
  EXPECT_EQ(scene.base.drop.particles, 250u);
  EXPECT_EQ(scene.base.particle_limit, 2500u);
  EXPECT_EQ(scene.base.particle_mass, 2.5);
  EXPECT_DOUBLE_EQ(scene.sph.smoothing_length, 16 * metres);
  EXPECT_EQ(std::get<IdealGas>(scene.sph.equation_of_state).k, 2000);
  EXPECT_EQ(std::get<IdealGas>(scene.sph.equation_of_state).rho0, 300);
  EXPECT_EQ(scene.sph.viscosity, 200);
  EXPECT_EQ(scene.base.time_step, 0.0007);
  EXPECT_EQ(scene.base.gravity, (Vec2{0, -10}));
  EXPECT_EQ(scene.base.wall.kind, WallKind::kReflect);
  EXPECT_EQ(scene.base.wall.restitution, 0.5);
  EXPECT_EQ(scene.base.fluid.arrange, Arrangement::kJittered);
  EXPECT_DOUBLE_EQ(scene.base.fluid.jitter, metres);
  EXPECT_DOUBLE_EQ(scene.view.x1, 1200 * metres);
  EXPECT_DOUBLE_EQ(scene.view.y1, 900 * metres);
  const Box legal = LegalRegion(scene.base.walls);  // its bounds are a kernel radius inside the view
  EXPECT_DOUBLE_EQ(legal.x0, 16 * metres);
  EXPECT_DOUBLE_EQ(legal.y0, 16 * metres);
  EXPECT_DOUBLE_EQ(legal.x1, (1200 - 16) * metres);
  EXPECT_DOUBLE_EQ(legal.y1, (900 - 16) * metres);
}

TEST(Tutorial, AsPublished) {
  const Scene scene = Load("mueller-published");
  ExpectTheTutorialsNumbers(scene, 1);
  EXPECT_TRUE(scene.sph.mueller_published);
  EXPECT_EQ(scene.base.integration, Integration::kSymplecticEuler);
  EXPECT_EQ(scene.base.fluid.spacing, 16);
}

TEST(Tutorial, PutRight) {
  const Scene scene = Load("mueller");
  ExpectTheTutorialsNumbers(scene, 0.01);
  EXPECT_FALSE(scene.sph.mueller_published);
  // At rest: the spacing for which 2.5 kg/m are 300 kg/m^3.
  EXPECT_NEAR(scene.base.fluid.spacing, std::sqrt(2.5 / 300), 5e-5);
}

}  // namespace
}  // namespace sph
