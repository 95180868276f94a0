// What Step, Reset and Draw of the base class promise.
#include "particles/particle_system.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "particles/diagnostics.hpp"

namespace sph {
namespace {

Parameters Base() {
  Parameters base;
  base.fluid.particles = 50;
  base.fluid.region.box = {0, 0, 1, 0.5};
  base.particle_mass = 1;
  base.time_step = 0.01;
  base.gravity = {0, -9.8};
  base.walls = {{"floor", FluidSide::kAbove, 0, 0, 0, 0}, {"right", FluidSide::kLeft, 1, 0, 0.5, 2}};
  base.wall.stiffness = 1000;
  return base;
}

/// Notes what it is asked to draw.
class Notebook : public Canvas {
 public:
  explicit Notebook(Colouring wanted) : wanted_(wanted) {}
  Colouring WantedColouring() const override { return wanted_; }
  void DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                 std::span<const double> values) override {
    disks = x.size();
    EXPECT_EQ(y.size(), x.size());
    EXPECT_TRUE(values.empty() || values.size() == x.size());
    EXPECT_GT(radius, 0);
    last_values.assign(values.begin(), values.end());
  }
  void DrawWall(Vec2, Vec2) override { ++walls; }

  std::size_t disks = 0;
  int walls = 0;
  std::vector<double> last_values;

 private:
  Colouring wanted_;
};

TEST(ParticleSystem, TimeIsTheSumOfTheSteps) {
  ParticleSystem system(Base());
  system.Reset();
  for (int k = 0; k < 7; ++k) system.Step();
  EXPECT_EQ(system.Steps(), 7);
  EXPECT_DOUBLE_EQ(system.Time(), 0.07);
}

TEST(ParticleSystem, ResetBringsBackTheSameBitsWhateverHappened) {
  ParticleSystem system(Base());
  system.Reset();
  const std::uint64_t start = Diagnose(system).state_hash;
  for (int k = 0; k < 20; ++k) system.Step();
  const std::uint64_t then = Diagnose(system).state_hash;
  EXPECT_NE(then, start);
  system.parameters.gravity = {5, 5};
  system.parameters.time_step = 0.02;
  system.parameters.walls[1].at = 0.6;
  system.Step();
  system.Reset();
  EXPECT_EQ(system.Time(), 0);
  EXPECT_EQ(system.Steps(), 0);
  EXPECT_EQ(system.DeepestPenetration(), 0);
  EXPECT_EQ(system.parameters.walls[1].at, 1);
  EXPECT_EQ(Diagnose(system).state_hash, start);
  for (int k = 0; k < 20; ++k) system.Step();
  EXPECT_EQ(Diagnose(system).state_hash, then);
}

TEST(ParticleSystem, OtherSeedsStartElsewhere) {
  Parameters base = Base();
  ParticleSystem one(base);
  base.seed = 2;
  ParticleSystem two(base);
  one.Reset();
  two.Reset();
  EXPECT_NE(Diagnose(one).state_hash, Diagnose(two).state_hash);
}

TEST(ParticleSystem, AVelocityThatIsNoNumberIsReportedWithStepAndParticle) {
  ParticleSystem system(Base());
  system.Reset();
  system.Step();
  system.parameters.gravity.y = std::numeric_limits<double>::quiet_NaN();
  system.Step();
  ASSERT_TRUE(system.Trouble());
  EXPECT_EQ(system.Trouble()->step, 2);
  EXPECT_EQ(system.Trouble()->id, 0u) << "all of them; the first is named";
  EXPECT_NE(system.Trouble()->Message().find("not a number"), std::string::npos) << system.Trouble()->Message();
  EXPECT_NE(system.Trouble()->Message().find("0.01 s"), std::string::npos) << system.Trouble()->Message();
  system.Step();
  EXPECT_EQ(system.Steps(), 2);
  system.Reset();
  EXPECT_FALSE(system.Trouble());
  system.Step();
  EXPECT_FALSE(system.Trouble());
}

TEST(ParticleSystem, MovesOfAnyLengthAreAllowedWithoutASupport) {
  Parameters base = Base();
  base.fluid.velocity = {1e100, 0};
  base.walls.clear();
  ParticleSystem system(base);
  system.Reset();
  system.Step();
  EXPECT_FALSE(system.Trouble());
}

TEST(ParticleSystem, DrawsAllParticlesAndTheWallsThatBoundThem) {
  ParticleSystem system(Base());
  system.Reset();
  Notebook black(Colouring::kBlackDisks);
  system.Draw(black);
  EXPECT_EQ(black.disks, 50u);
  EXPECT_EQ(black.walls, 2);
  EXPECT_TRUE(black.last_values.empty());
}

TEST(ParticleSystem, DrawsSpeedsWhenTheCanvasWantsThemAndNothingForWhatItLacks) {
  Parameters base = Base();
  base.fluid.velocity = {3, 4};
  ParticleSystem system(base);
  system.Reset();
  Notebook speed(Colouring::kSpeed);
  system.Draw(speed);
  ASSERT_EQ(speed.last_values.size(), 50u);
  EXPECT_EQ(speed.last_values[17], 5);
  Notebook pressure(Colouring::kPressure);
  system.Draw(pressure);
  EXPECT_TRUE(pressure.last_values.empty());
}

TEST(ParticleSystem, PlanSaysWhatRunsAndWhatDoesNot) {
  const auto runs = [](const Parameters& p, const std::string& pass) {
    for (const PassPlan& plan : ParticleSystem(p).Plan()) {
      if (plan.name == pass) return plan.runs;
    }
    ADD_FAILURE() << "no pass " << pass;
    return false;
  };
  Parameters with = Base();
  with.motion_damping = 1;
  Parameters without = Base();
  without.gravity = {};
  without.walls.clear();
  for (const char* pass : {"gravity", "motion damping", "walls"}) {
    EXPECT_TRUE(runs(with, pass)) << pass;
    EXPECT_FALSE(runs(without, pass)) << pass;
  }
}

TEST(ParticleSystem, RefusesAStepOrAMassThatIsNotPositive) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  Parameters base = Base();
  base.time_step = 0;
  EXPECT_DEATH(ParticleSystem{base}, "dt = 0");
  base = Base();
  base.particle_mass = -1;
  EXPECT_DEATH(ParticleSystem{base}, "m = -1");
}

TEST(ParticleSystem, StartsWithTheParticlesThatItIsGiven) {
  auto start = std::make_shared<GivenStart>();
  start->particles.Add({1, 2}, {3, 4}, 0.5);
  start->particles.Add({5, 6}, {0, 0}, 0.25);
  Parameters base = Base();
  base.walls.clear();
  base.given = start;
  ParticleSystem system(base);
  for (int round = 0; round < 2; ++round) {
    system.Reset();
    ASSERT_EQ(system.State().Size(), 2u);
    EXPECT_EQ(system.State().Position(0), (Vec2{1, 2}));
    EXPECT_EQ(system.State().Velocity(0), (Vec2{3, 4}));
    EXPECT_EQ(system.State().mass[1], 0.25);
    system.Step();
    EXPECT_FALSE(system.Trouble());
  }
}

TEST(ParticleSystem, CannotStartWithWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), far = std::numeric_limits<double>::infinity();
  struct Broken {
    Vec2 position, velocity;
    double mass;
    const char* says;
  };
  for (const Broken& broken : {Broken{{nan, 0}, {}, 1, "position"}, Broken{{0, -far}, {}, 1, "position"},
                               Broken{{0, 1e200}, {}, 1, "position"}, Broken{{}, {0, nan}, 1, "velocity"},
                               Broken{{}, {1e200, 0}, 1, "velocity"}, Broken{{}, {}, nan, "mass"}}) {
    auto start = std::make_shared<GivenStart>();
    start->particles.Add({}, {}, 1);
    start->particles.Add(broken.position, broken.velocity, broken.mass);
    Parameters base = Base();
    base.given = start;
    ParticleSystem system(base);
    system.Reset();
    ASSERT_TRUE(system.Trouble()) << broken.says;
    EXPECT_EQ(system.Trouble()->id, 1u);
    EXPECT_EQ(system.Trouble()->step, 0);
    EXPECT_NE(system.Trouble()->limit.find(broken.says), std::string::npos) << system.Trouble()->limit;
  }
}

}  // namespace
}  // namespace sph
