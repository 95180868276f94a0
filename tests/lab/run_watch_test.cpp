// What scenes promise, and that a watched run is found out when it breaks its promise, and left alone when it does not.
#include "lab/run_watch.hpp"

#include <gtest/gtest.h>

#include "scenes/build.hpp"
#include "scenes/scene_file.hpp"
#include "sph/delta.hpp"

namespace sph {
namespace {

/// Water at rest, 12 wide and 10 high, in a tank; some of it can be set otherwise.
Scene Water(const std::vector<std::string>& settings = {}) {
  return ParseScene(R"(
title = "water"
solver = "delta"
fluid = { particles = 120, mass = 10.0, arrange = "lattice", flow = "hydrostatic", region = { box = [0.0, 0.0, 1.2, 1.0] } }
equation_of_state.ideal_gas = { k = 10000.0, rho0 = 1000.0 }
method = { kernel = "wendland-c2", smoothing_length = 0.2, time_step = 0.0005, step = "adaptive" }
forces.gravity = [0.0, -9.81]
walls.kind = "mirror"
wall = [ { name = "left", at = 0.0, fluid = "right" }, { name = "right", at = 1.2, fluid = "left" },
         { name = "floor", at = 0.0, fluid = "above" } ]
)",
                    "water.toml", settings);
}

Promises PromisesOfWater(const std::vector<std::string>& settings = {}) {
  Scene scene = Water(settings);
  scene.base.threads = 1;
  return PromisesOf(scene, *MakeSystem(scene));
}

TEST(Promises, OfWaterAtRestAreAll) {
  const Promises all = PromisesOfWater();
  EXPECT_TRUE(all.energy && all.volume && all.rest && all.calm);
  EXPECT_TRUE(PromisesOfWater({"fluid.arrange=relaxed"}).rest);
}

TEST(Promises, OfRestTakeABalance) {
  EXPECT_FALSE(PromisesOfWater({"fluid.velocity=[0.1,0.0]"}).rest);
  EXPECT_FALSE(PromisesOfWater({"wall.right.at=2.0"}).rest) << "it breaks like a dam";
  EXPECT_FALSE(PromisesOfWater({"forces.gravity=[1.0,-9.8]"}).rest) << "its surface is not level";
  EXPECT_FALSE(PromisesOfWater({"fluid.flow=rest"}).rest) << "it is pressed together first";
}

TEST(Promises, OfALiquidTakeAMethodThatIsWithinItsRange) {
  for (const char* setting : {"equation_of_state.ideal_gas.k=100.0", "fluid.mass=5.0", "method.smoothing_length=0.1",
                              "walls.kind=penalty", "fluid.flow=breathing-star"}) {
    const Promises promises = PromisesOfWater({setting});
    EXPECT_FALSE(promises.energy || promises.volume || promises.calm) << setting;
  }
}

TEST(Promises, OfEnergyAreNoneOfSolverMueller) {
  const auto tank = [](const char* solver) {
    Scene scene = ParseScene(fmt::format(R"(
title = "tank"
solver = "{}"
fluid = {{ particles = 50, mass = 10.0, region = {{ box = [0.0, 0.0, 1.0, 0.5] }} }}
equation_of_state.ideal_gas = {{ k = 400.0, rho0 = 1000.0 }}
method = {{ smoothing_length = 0.15, time_step = 0.0005 }}
)",
                                         solver),
                             "tank.toml");
    return PromisesOf(scene, *MakeSystem(scene)).energy;
  };
  EXPECT_TRUE(tank("paper"));
  EXPECT_FALSE(tank("mueller"));
}

/// Water with whose particles and parameters anything can be done.
class OpenWater final : public Delta {
 public:
  explicit OpenWater(const Scene& scene) : Delta(CompleteParameters(scene), scene.sph) { Reset(); }

  void Sink(double factor) {
    for (double& y : particles_.y) y *= factor;
    ForgetNeighbours();
  }
  void Push(double velocity) {
    for (auto* vx : {&particles_.vx, &particles_.vx_prev}) {
      for (double& v : *vx) v += velocity;
    }
  }
};

template <typename Meddle>
std::string FlawOfWater(const std::vector<std::string>& settings, Meddle meddle, long steps = 600) {
  Scene scene = Water(settings);
  scene.base.threads = 1;
  OpenWater water(scene);
  RunWatch watch(scene, water);
  for (long k = 1; k <= steps; ++k) {
    water.Step();
    meddle(water, k);
    if (k % RunWatch::kStepsApart == 0) watch.Look();
  }
  return watch.Flaw();
}

TEST(RunWatch, LeavesHealthyWaterAlone) {
  const auto nothing = [](OpenWater&, long) {};
  EXPECT_EQ(FlawOfWater({}, nothing), "");
  EXPECT_EQ(FlawOfWater({"wall.right.at=1.8"}, nothing), "") << "sloshing";
  EXPECT_EQ(FlawOfWater({"fluid.velocity=[0.3,0.0]"}, nothing), "");
}

TEST(RunWatch, FindsWaterThatSinksUnderItsDensity) {
  const auto sink = [](OpenWater& water, long) { water.Sink(0.9996); };
  const std::string flaw = FlawOfWater({}, sink);
  EXPECT_NE(flaw.find("the area that particles fill"), std::string::npos) << "flaw: " << flaw;
}

TEST(RunWatch, FindsEnergyThatIsPumped) {
  const auto pump = [](OpenWater& water, long) { water.parameters.motion_damping = -3; };
  const std::string flaw = FlawOfWater({"fluid.velocity=[1.0,0.0]"}, pump);
  EXPECT_NE(flaw.find("energy grew"), std::string::npos) << "flaw: " << flaw;
}

TEST(RunWatch, FindsRestThatIsLostToMotionThatWasStored) {
  const auto open = [](OpenWater& water, long step) {
    if (step == 400) FindWall(water.parameters.walls, "right")->at = 1.5;
  };
  const std::string flaw = FlawOfWater({}, open);
  EXPECT_NE(flaw.find("no rest"), std::string::npos) << flaw;
}

TEST(RunWatch, DoesNotCompareAcrossWhatSomebodyDid) {
  Scene scene = Water();
  scene.base.threads = 1;
  OpenWater water(scene);
  RunWatch watch(scene, water);
  for (int k = 0; k < 300; ++k) {
    if (k == 150) {
      water.Push(0.5);
      watch.Disturbed();
    }
    water.Step();
    if (k % RunWatch::kStepsApart == 0) watch.Look();
  }
  EXPECT_EQ(watch.Flaw(), "");
}

TEST(RunWatch, FindsAStepThatBreaksDownWithinItsLimits) {
  Scene scene = Water();
  scene.base.threads = 1;
  OpenWater water(scene);
  RunWatch watch(scene, water);
  watch.Look();
  watch.BrokeDown("it burst");
  EXPECT_NE(watch.Flaw().find("it burst"), std::string::npos);
}

TEST(RunWatch, KnowsWhatASoftWallHoldsOfAFluidThatBouncesOffIt) {
  Scene scene = ParseScene(R"(
title = "bounce"
fluid = { particles = 25, mass = 0.01, arrange = "lattice", velocity = [0.0, -1.0], region = { box = [0.0, 0.0, 0.5, 0.5] } }
equation_of_state.polytrope.k = 1e-6
method = { smoothing_length = 0.1, time_step = 0.001 }
walls = { kind = "penalty", stiffness = 10.0 }
wall = [ { name = "floor", at = 0.0, fluid = "above" } ]
)",
                           "bounce.toml");
  scene.base.threads = 1;
  const auto system = MakeSystem(scene);
  RunWatch watch(scene, *system);
  for (long k = 1; k <= 1500; ++k) {
    system->Step();
    if (k % RunWatch::kStepsApart == 0) watch.Look();
  }
  EXPECT_GT(system->DeepestPenetration(), 0.2) << "it stops in the wall for a while";
  EXPECT_GT(system->State().vy[0], 0.5) << "and comes back";
  EXPECT_EQ(watch.Flaw(), "");
}

TEST(RunWatch, CountsTheWorkOfAForceAlongAPeriodAsPutIn) {
  Scene scene = ParseScene(R"(
title = "carried along"
solver = "delta"
fluid = { particles = 196, mass = 5.1020408163265307, arrange = "lattice", region = { box = [0.0, 0.0, 1.0, 1.0] } }
equation_of_state.ideal_gas = { k = 10000.0, rho0 = 1000.0 }
method = { kernel = "wendland-c2", smoothing_length = 0.1, step = "fixed", time_step = 0.0005 }
forces.gravity = [3.0, 0.0]
periodic = { box = [0.0, 0.0, 1.0, 1.0], directions = "both" }
)",
                           "carried.toml");
  scene.base.threads = 1;
  const auto system = MakeSystem(scene);
  RunWatch watch(scene, *system);
  for (long k = 1; k <= 1000; ++k) {
    system->Step();
    if (k % RunWatch::kStepsApart == 0) watch.Look();
  }
  EXPECT_TRUE(watch.Promised().energy);
  EXPECT_EQ(watch.Flaw(), "") << "it fell 0.4 m and came to 1.5 m/s";
}

}  // namespace
}  // namespace sph
