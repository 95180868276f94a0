// Every scene key goes to its own place, takes its own kind of value, and can be set from the command line.
#include "scenes/scene_keys.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "scenes/scene_text.hpp"

namespace sph {
namespace {

struct Example {
  std::string setting;                        ///< key=value
  std::function<bool(const Scene&)> arrives;  ///< whether the scene says so
};

/// The scene's equation of state; one without numbers if it is of another type.
template <typename Equation>
Equation As(const Scene& s) {
  const auto* equation = std::get_if<Equation>(&s.sph.equation_of_state);
  return equation != nullptr ? *equation : Equation{};
}

// clang-format off
const std::vector<Example> kExamples = {
    {"title=T", [](const Scene& s) { return s.title == "T"; }},
    {"about=A", [](const Scene& s) { return s.about == "A"; }},
    {"solver=mueller", [](const Scene& s) { return s.solver == "mueller"; }},
    {"seed=9223372036854775807", [](const Scene& s) { return s.base.seed == 9223372036854775807ULL; }},
    {"until=2", [](const Scene& s) { return s.until == 2; }},
    {"view=[0,1,2,3]", [](const Scene& s) { return s.view == Box{0, 1, 2, 3}; }},
    {"fluid.particles=3", [](const Scene& s) { return s.base.fluid.particles == 3; }},
    {"fluid.mass=4", [](const Scene& s) { return s.base.particle_mass == 4; }},
    {"fluid.region.box=[0,0,2,3]", [](const Scene& s) { return s.base.fluid.region.box == Box{0, 0, 2, 3}; }},
    {"fluid.region.disk.centre=[7,8]", [](const Scene& s) { return s.base.fluid.region.centre == Vec2{7, 8}; }},
    {"fluid.region.disk.radius=0.1", [](const Scene& s) { return s.base.fluid.region.radius == 0.1; }},
    {"fluid.arrange=jittered", [](const Scene& s) { return s.base.fluid.arrange == Arrangement::kJittered; }},
    {"fluid.spacing=0.3", [](const Scene& s) { return s.base.fluid.spacing == 0.3; }},
    {"fluid.jitter=0.4", [](const Scene& s) { return s.base.fluid.jitter == 0.4; }},
    {"fluid.settle={time=0.1,damping=2}",
     [](const Scene& s) { return s.settling.time == 0.1 && s.settling.damping == 2; }},
    {"fluid.velocity=[1,-2]", [](const Scene& s) { return s.base.fluid.velocity == Vec2{1, -2}; }},
    {"fluid.limit=55", [](const Scene& s) { return s.base.particle_limit == 55; }},
    {"drop.particles=6", [](const Scene& s) { return s.base.drop.particles == 6; }},
    {"drop.box=[1,2,3,4]", [](const Scene& s) { return s.base.drop.region.box == Box{1, 2, 3, 4}; }},
    {"drop.spacing=0.7", [](const Scene& s) { return s.base.drop.spacing == 0.7; }},
    {"drop.velocity=[3,4]", [](const Scene& s) { return s.base.drop.velocity == Vec2{3, 4}; }},
    {"method.smoothing_length=0.8", [](const Scene& s) { return s.sph.smoothing_length == 0.8; }},
    {"method.time_step=0.9", [](const Scene& s) { return s.base.time_step == 0.9; }},
    {"method.retries=7", [](const Scene& s) { return s.retries == 7; }},
    {"method.integration=leapfrog-published",
     [](const Scene& s) { return s.base.integration == Integration::kLeapFrogPublished; }},
    {"method.integration=symplectic-euler",
     [](const Scene& s) { return s.base.integration == Integration::kSymplecticEuler; }},
    {"method.kernel=quintic", [](const Scene& s) { return s.sph.delta.kernel == SmoothingKernel::kQuintic; }},
    {"method.viscous_form=laplacian",
     [](const Scene& s) { return s.sph.delta.viscous_form == ViscousForm::kLaplacian; }},
    {"method.sound_damping=0.4", [](const Scene& s) { return s.sph.delta.sound_damping == 0.4; }},
    {"method.form=published", [](const Scene& s) { return s.sph.mueller_published; }},
    {"equation_of_state.polytrope.k=1.1", [](const Scene& s) { return As<Polytrope>(s).k == 1.1; }},
    {"equation_of_state.tait.k=1.2", [](const Scene& s) { return As<Tait>(s).k == 1.2 && As<Tait>(s).rho0 == 1; }},
    {"equation_of_state.tait.rho0=1.3", [](const Scene& s) { return As<Tait>(s).rho0 == 1.3 && As<Tait>(s).k == 0.5; }},
    {"equation_of_state.tait.exponent=3", [](const Scene& s) { return As<Tait>(s).exponent == 3; }},
    {"equation_of_state.ideal_gas={k=1.4,rho0=1.5}",
     [](const Scene& s) { return As<IdealGas>(s).k == 1.4 && As<IdealGas>(s).rho0 == 1.5; }},
    {"forces.gravity=[1.6,1.7]", [](const Scene& s) { return s.base.gravity == Vec2{1.6, 1.7}; }},
    {"forces.central=-1.8", [](const Scene& s) { return s.base.central_force == -1.8; }},
    {"forces.damping=1.9", [](const Scene& s) { return s.base.motion_damping == 1.9; }},
    {"forces.viscosity=2.1", [](const Scene& s) { return s.sph.viscosity == 2.1; }},
    {"forces.surface_tension=0.07", [](const Scene& s) { return s.sph.delta.surface_tension == 0.07; }},
    {"walls.kind=reflect", [](const Scene& s) { return s.base.wall.kind == WallKind::kReflect; }},
    {"walls.stiffness=2.2", [](const Scene& s) { return s.base.wall.stiffness == 2.2; }},
    {"walls.damping=2.3", [](const Scene& s) { return s.base.wall.damping == 2.3; }},
    {"walls.restitution=0.25", [](const Scene& s) { return s.base.wall.restitution == 0.25; }},
    {"walls.scaling=published", [](const Scene& s) { return s.wall_scaling == WallScaling::kPublished; }},
    {"arrows={wall='floor',speed=2.4}", [](const Scene& s) { return s.arrow_wall == "floor" && s.arrow_speed == 2.4; }},
};
// clang-format on

TEST(SceneKeys, GoEachToTheirOwnPlace) {
  const Scene before = SceneFrom(kScene);
  for (const Example& example : kExamples) {
    std::vector<std::string> settings = {example.setting};
    const SceneKey* key = FindSceneKey(settings[0].substr(0, settings[0].find('=')));
    if (key != nullptr && !key->UsedBy(before.solver)) settings.push_back("solver=" + key->solvers.front());
    EXPECT_FALSE(example.arrives(before)) << example.setting << " changes nothing";
    EXPECT_TRUE(example.arrives(SceneFrom(kScene, settings))) << example.setting;
  }
}

TEST(SceneKeys, OfAStarGoTogether) {
  const Scene scene = SceneFrom(kScene, {"equation_of_state.polytrope.k=0.1", "forces.star.mass=2",
                                         "forces.star.radius=0.75", "reference=static-star"});
  EXPECT_EQ(scene.star->mass, 2);
  EXPECT_EQ(scene.star->radius, 0.75);
  EXPECT_EQ(scene.reference, Reference::kStaticStar);
}

TEST(SceneKeys, AllRefuseAValueOfNoKnownKind) {
  for (const SceneKey& key : AllSceneKeys()) {
    EXPECT_TRUE(Has(Refusal(kScene, {key.name + "=[true]"}), {"--set: " + key.name + " = ", "it takes"})) << key.name;
  }
}

TEST(SceneKeys, AreAllDifferentFoundByNameAndExplained) {
  std::set<std::string> names;
  for (const SceneKey& key : AllSceneKeys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_EQ(FindSceneKey(key.name), &key);
    EXPECT_FALSE(key.what.empty()) << key.name;
  }
  EXPECT_EQ(FindSceneKey("fluid"), nullptr) << "a table is not a key";
}

TEST(SceneKeys, NoneIsThePrefixOfAnotherSoThatATableIsNeverTakenForAValue) {
  for (const SceneKey& key : AllSceneKeys()) {
    for (const SceneKey& other : AllSceneKeys()) EXPECT_FALSE(other.name.starts_with(key.name + ".")) << other.name;
  }
}

}  // namespace
}  // namespace sph
