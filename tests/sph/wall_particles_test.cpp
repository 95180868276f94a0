// Wall particles: the pass on vectors against the sums over all pairs; and what walls made of them hold.
#include "sph/wall_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/diagnostics.hpp"
#include "sph/delta.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_delta_twins.hpp"

namespace sph {
namespace {

constexpr double kSound = 20, kRho0 = 1000;
constexpr Vec2 kGravity{0.5, -2};

/// Clouds whose values are told by where and who the particles are, and the means at the places of the same particles.
template <typename Real>
struct Setting {
  explicit Setting(const Cloud& given) : found(FindNeighbours<Real>(given, 2 * kCloudH)), cloud(found.cloud) {
    const std::size_t room = cloud.Size() + kPadding;
    for (auto* values : {&pressure, &excess, &vx, &vy, &wholeness}) values->resize(room);
    for (std::size_t i = 0; i < cloud.Size(); ++i) {
      pressure[i] = static_cast<Real>(std::sin(40 * cloud.x[i]));
      excess[i] = static_cast<Real>(cloud.mass[i]);
      vx[i] = static_cast<Real>(cloud.vx[i]);
      vy[i] = static_cast<Real>(cloud.vy[i]);
      wholeness[i] = static_cast<Real>(std::cos(30 * cloud.y[i]));
    }
  }
  Setting(const Setting&) = delete;  // `cloud` refers to `found`

  WallValues<Real> Compute() const {
    WaterInput<Real> water;
    water.pressure = pressure.data();
    water.excess = excess.data();
    water.vx = vx.data();
    water.vy = vy.data();
    water.wholeness = wholeness.data();
    water.rho0 = kRho0;
    WallValues<Real> values;
    values.Resize(cloud.Size() + kPadding);
    for (const ListBlock& block : found.search.Blocks()) {
      ComputeWallValues(found.Input(), water, found.search.Sets()[0], block, kGravity, kSound, values);
    }
    return values;
  }

  Neighbourhood<Real> found;
  const Cloud& cloud;
  std::vector<Real> pressure, excess, vx, vy, wholeness;
};

template <typename Real>
class WallParticles : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(WallParticles, BothPrecisions);

TYPED_TEST(WallParticles, HaveTheMeansOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& given : AllClouds()) {
      const Setting<TypeParam> s(given);
      const WallValues<TypeParam> values = s.Compute();
      const WendlandC2 kernel(kCloudH);
      for (std::size_t i = 0; i < s.cloud.Size(); ++i) {
        double sum = 0, pressure = 0, excess = 0, vx = 0, vy = 0, wholeness = 0;
        for (std::size_t j = 0; j < s.cloud.Size(); ++j) {
          const Vec2 d{s.cloud.x[i] - s.cloud.x[j], s.cloud.y[i] - s.cloud.y[j]};
          const double w = kernel.Value(Length(d));
          const double drop = (kRho0 + static_cast<double>(s.excess[j])) * Dot(kGravity, d);
          sum += w;
          pressure += w * (static_cast<double>(s.pressure[j]) + drop);
          excess += w * (static_cast<double>(s.excess[j]) + drop / (kSound * kSound));
          vx += w * static_cast<double>(s.vx[j]);
          vy += w * static_cast<double>(s.vy[j]);
          wholeness += w * static_cast<double>(s.wholeness[j]);
        }
        const double tolerance = 4 * kTolerance<TypeParam>;
        const double steepest = kRho0 * Length(kGravity) * 2 * kCloudH;  // the greatest drop [Pa]
        ASSERT_NEAR(values.pressure[i], pressure / sum, tolerance * (1 + steepest)) << s.cloud.name << ", " << i;
        ASSERT_NEAR(values.excess[i], excess / sum, tolerance * (2 + steepest / (kSound * kSound))) << s.cloud.name;
        ASSERT_NEAR(values.vx[i], vx / sum, tolerance) << s.cloud.name;
        ASSERT_NEAR(values.vy[i], vy / sum, tolerance) << s.cloud.name;
        ASSERT_NEAR(values.wholeness[i], wholeness / sum, tolerance) << s.cloud.name;
      }
    }
  });
}

/// Water between walls of particles, 2 x 1 metres; c = 20 m/s.
Parameters Tank() {
  Parameters base;
  base.fluid.region = {{0, 0, 2, 1}, {}, 0};
  base.fluid.particles = 800;
  base.fluid.arrange = Arrangement::kLattice;
  base.particle_mass = 2 * kRho0 / 800;
  base.time_step = 1e-3;
  base.walls = {{.name = "left", .fluid = FluidSide::kRight, .at = 0},
                {.name = "right", .fluid = FluidSide::kLeft, .at = 2},
                {.name = "floor", .fluid = FluidSide::kAbove, .at = 0}};
  base.wall.kind = WallKind::kParticles;
  return base;
}

ParametersSPH Water() {
  ParametersSPH water;
  water.smoothing_length = 0.1;
  water.equation_of_state = IdealGas{kSound * kSound, kRho0};
  return water;
}

TEST(WallsOfParticles, CarryWaterWhosePressureIsThatOfItsWeight) {
  Parameters base = Tank();
  base.gravity = {0, -2};
  ParametersSPH water = Water();
  water.flow = &*std::ranges::find(AllInitialFlows(), "hydrostatic", &InitialFlow::name);
  water.graded_masses = true;
  Delta system(base, water);
  system.Reset();
  const Particles& p = system.State();
  for (std::size_t i = 0; i < p.Size(); ++i) {
    if (p.y[i] < 0.75) {
      EXPECT_LT(std::hypot(p.ax[i], p.ay[i]), 0.03 * 2) << p.x[i] << ", " << p.y[i];
    }
  }
}

TEST(WallsOfParticles, KeepFluidInThatAWallPushesAndThatIsThrownAtThem) {
  Parameters base = Tank();
  base.gravity = {0, -2};
  base.walls[1].velocity = -0.5;
  base.walls[1].lowest = 1.6;
  base.walls[1].highest = 2;
  base.time_step = 5e-4;
  GivenLiquid system(base, Water(), [](Vec2 x) { return Vec2{x.x < 1 ? -3.0 : 0, x.y < 0.5 ? -3.0 : 0}; });
  for (int k = 0; k < 2000 && !system.Trouble(); ++k) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
  EXPECT_NEAR(system.parameters.walls[1].at, 1.6, 1e-12);
  const Particles& p = system.State();
  EXPECT_GE(*std::ranges::min_element(p.x), 0);
  EXPECT_LE(*std::ranges::max_element(p.x), 1.6);
  EXPECT_GE(*std::ranges::min_element(p.y), 0);
  EXPECT_LT(Diagnose(system).max_speed, 4.5) << "3 sqrt(2) at the start";
}

TEST(WallsOfParticles, DragTheFluidThatSticksToThemAndNoOther) {
  for (const bool sticks : {true, false}) {
    Parameters base = Tank();
    base.fluid.region = {{0, 0, 1, 1}, {}, 0};
    base.fluid.particles = 1600;
    base.particle_mass = kRho0 / 1600;
    base.time_step = 2e-4;
    base.walls = {{.name = "left", .fluid = FluidSide::kRight, .at = 0},
                  {.name = "right", .fluid = FluidSide::kLeft, .at = 1, .tangential = {0.3}}};
    base.wall.no_slip = sticks;
    ParametersSPH water = Water();
    water.smoothing_length = 0.05;
    water.viscosity = 500;  // half a square metre a second: within 0.02 s it reaches a tenth of a metre from the walls
    water.delta.viscous_form = ViscousForm::kStress;
    water.periods = {{0, 0, 1, 1}, false, true};
    const auto steady = [&](Vec2 x) { return Vec2{0, sticks ? 0.3 * x.x : 0}; };
    GivenLiquid system(base, water, steady);
    for (int k = 0; k < 100; ++k) system.Step();
    ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
    double worst = 0;
    const Particles& p = system.State();
    for (std::size_t i = 0; i < p.Size(); ++i) worst = std::max(worst, Length(p.Velocity(i) - steady(p.Position(i))));
    EXPECT_LT(worst, sticks ? 0.3 * 0.02 : 1e-8) << "densities that are tied to the lattice's push a little";
  }
}

}  // namespace
}  // namespace sph
