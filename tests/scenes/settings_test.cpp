// --set KEY=VALUE: as in the file, after the file.
#include <gtest/gtest.h>

#include "scenes/scene_file.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

std::string RefusalOf(const std::string& setting) { return Refusal(kScene, {setting}); }

TEST(Settings, TakeEffectAfterTheFileAndInTheirOrder) {
  EXPECT_EQ(SceneFrom(kScene, {"method.time_step=0.5"}).base.time_step, 0.5);
  EXPECT_EQ(SceneFrom(kScene, {"method.time_step=0.5", "method.time_step=0.25"}).base.time_step, 0.25);
}

TEST(Settings, TakeNamesWithAndWithoutQuotesAndSpaces) {
  for (const char* setting : {"solver=mueller", "solver='mueller'", "solver = \"mueller\"", "solver =mueller"}) {
    EXPECT_TRUE(
        Has(SceneFrom(kScene, {"equation_of_state.ideal_gas={k=1,rho0=1}", "solver='mueller'"}).solver, {"mueller"}))
        << setting;
  }
  EXPECT_EQ(SceneFrom(kScene, {"title=An unquoted title, with = and #"}).title, "An unquoted title, with = and #");
}

TEST(Settings, TakeWholeTables) {
  const Scene scene = SceneFrom(kScene, {"forces={ gravity=[0, -1], damping=3 }"});
  EXPECT_EQ(scene.base.gravity, (Vec2{0, -1}));
  EXPECT_EQ(scene.base.motion_damping, 3);
}

TEST(Settings, ReplaceTheEquationOfStateAndTheRegionByOthers) {
  const Scene gas = SceneFrom(kScene, {"equation_of_state.polytrope.k=0.2"});
  EXPECT_EQ(std::get<Polytrope>(gas.sph.equation_of_state).k, 0.2);
  const Scene disk = SceneFrom(kScene, {"fluid.region.disk={centre=[0.5,0.5],radius=0.25}"});
  EXPECT_EQ(disk.base.fluid.region.Bounds(), (Box{0.25, 0.25, 0.75, 0.75}));
  const Scene box = SceneFrom(kScene, {"fluid.region.disk.radius=3", "fluid.region.box=[0,0,1,2]"});
  EXPECT_EQ(box.base.fluid.region.Bounds(), (Box{0, 0, 1, 2}));
}

TEST(Settings, ReachWallsByName) {
  const Scene scene = SceneFrom(kScene, {"wall.floor.range=[-3,3]", "wall.floor.at=-2"});
  EXPECT_EQ(scene.base.walls[0].at, -2);
  EXPECT_TRUE(Has(RefusalOf("wall.flor.at=0"), {"--set", "no wall 'flor'", "Did you mean 'floor'?"}));
  EXPECT_TRUE(Has(RefusalOf("wall.floor.att=0"), {"--set", "wall.floor.att", "Did you mean 'at'?"}));
  EXPECT_TRUE(Has(RefusalOf("wall.floor.at=7"), {"--set: wall.floor.at = 7", ">= -0.5 and <= 0.5"}));
  EXPECT_TRUE(Has(RefusalOf("wall.floor=7"), {"--set"}));
  EXPECT_TRUE(Has(RefusalOf("wall=7"), {"--set", "wall"}));
}

TEST(Settings, WithoutKeyOrValueAreRefusedWithAnExample) {
  EXPECT_TRUE(Has(RefusalOf("forces.damping"), {"--set forces.damping", "KEY=VALUE"}));
  EXPECT_TRUE(Has(RefusalOf("=3"), {"--set =3", "KEY=VALUE"}));
  EXPECT_TRUE(Has(RefusalOf(""), {"KEY=VALUE"}));
  EXPECT_TRUE(Has(RefusalOf("forces.damping="), {"--set: forces.damping = ''", "a finite number >= 0"}));
}

TEST(Settings, ThatAreNoKeysAreRefused) {
  for (const char* setting :
       {"a b=3", "[x]=3", "forces..damping=3", ".damping=3", "forces.=3", "\"=3", "#=3", " #=3", " =3"}) {
    EXPECT_NE(RefusalOf(setting), "accepted") << setting;
  }
}

TEST(Settings, AreCheckedLikeTheFile) {
  EXPECT_TRUE(Has(RefusalOf("method.timestep=1"), {"--set", "Did you mean 'method.time_step'?"}));
  EXPECT_TRUE(Has(RefusalOf("method.time_step=-1"), {"--set: method.time_step = -1", "> 0"}));
  EXPECT_TRUE(Has(RefusalOf("method.time_step=1e999"), {"--set: method.time_step", "> 0"}));
  EXPECT_TRUE(Has(RefusalOf("method.time_step=soon"), {"--set: method.time_step = 'soon'", "> 0"}));
  EXPECT_TRUE(Has(RefusalOf("fluid.particles=1.5"), {"--set: fluid.particles = 1.5", "a whole number"}));
  EXPECT_TRUE(Has(RefusalOf("solver=sph"), {"--set: solver = 'sph'", "paper, mueller"}));
  EXPECT_TRUE(Has(RefusalOf("fluid.region.box=[0,-5,1,1]"), {"behind a wall"}));
  EXPECT_TRUE(Has(RefusalOf("key=3"), {"--set", "[[key]]"}));
}

TEST(Settings, HoldOneKeyEach) {
  // A line break would smuggle in a second key unseen.
  EXPECT_NE(RefusalOf("until=3\nseed=4"), "accepted");
}

}  // namespace
}  // namespace sph
