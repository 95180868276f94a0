// Walls to which the fluid sticks: the velocities behind them, what the density sees of those, and flows that such
// walls drive, against exact solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/given_system.hpp"

namespace sph {
namespace {

using std::numbers::pi;

Wall At(FluidSide fluid, double at, double tangential = 0) {
  Wall wall{.name = "wall", .fluid = fluid, .at = at};
  wall.tangential.mean = tangential;
  return wall;
}

WallParameters StickingMirrors() {
  WallParameters all;
  all.kind = WallKind::kMirror;
  all.no_slip = true;
  return all;
}

TEST(SideVelocities, AreTurnedRoundRelativeToTheWallWhereItPrescribesThem) {
  Wall floor = At(FluidSide::kAbove, 0, 3);
  floor.velocity = 0.5;
  const std::vector<Wall> walls = {floor};
  const Vec2 v{1, -2};
  const auto whole = SideVelocities::ForForces(walls, StickingMirrors(), 0);
  EXPECT_EQ(whole.Behind(v, Beyond::kNone, Beyond::kLow), (Vec2{5, 3}));
  EXPECT_EQ(whole.Behind(v, Beyond::kNone, Beyond::kNone), v);
  EXPECT_EQ(SideVelocities::ForDensity(walls, 0).Behind(v, Beyond::kNone, Beyond::kLow), (Vec2{1, 3}));
}

TEST(SideVelocities, FollowTheWallsTimeAndItsOwnSlip) {
  std::vector<Wall> walls = {At(FluidSide::kAbove, 0), At(FluidSide::kBelow, 1, 7)};
  walls[0].tangential = {1, 2, 0.25, 0.5};
  walls[1].no_slip = false;
  const auto later = SideVelocities::ForForces(walls, StickingMirrors(), 3);
  EXPECT_DOUBLE_EQ(later.Behind({}, Beyond::kNone, Beyond::kLow).x, 2 * (1 + 2 * std::sin(1.5 * pi + 0.5)));
  EXPECT_EQ(later.Behind({4, 0}, Beyond::kNone, Beyond::kHigh).x, 4) << "it slips along this one";
}

TEST(SideVelocities, InACornerAreTheMeanOfBothOrdersOfTurningRound) {
  const Vec2 v{0.3, -0.7};
  for (const bool side_sticks : {true, false}) {
    std::vector<Wall> walls = {At(FluidSide::kRight, 0, 0.25), At(FluidSide::kBelow, 1, 1)};
    walls[0].velocity = 0.125;
    walls[0].no_slip = side_sticks;
    const auto whole = SideVelocities::ForForces(walls, StickingMirrors(), 0);
    const Vec2 x_first = whole.Behind(whole.Behind(v, Beyond::kLow, Beyond::kNone), Beyond::kNone, Beyond::kHigh);
    const Vec2 y_first = whole.Behind(whole.Behind(v, Beyond::kNone, Beyond::kHigh), Beyond::kLow, Beyond::kNone);
    const Vec2 corner = whole.Behind(v, Beyond::kLow, Beyond::kHigh);
    EXPECT_NEAR(corner.x, 0.5 * (x_first.x + y_first.x), 1e-15);
    EXPECT_NEAR(corner.y, 0.5 * (x_first.y + y_first.y), 1e-15);
  }
}

TEST(SideVelocities, AreThoseOfTheWallThatBoundsTheFluidWhateverTheOrder) {
  Wall dam = At(FluidSide::kLeft, 0.5, 2);
  dam.velocity = -1;
  const Wall outer = At(FluidSide::kLeft, 1, 9);
  for (const std::vector<Wall>& walls : {std::vector{dam, outer}, std::vector{outer, dam}}) {
    const auto whole = SideVelocities::ForForces(walls, StickingMirrors(), 0);
    EXPECT_EQ(whole.Behind({}, Beyond::kHigh, Beyond::kNone), (Vec2{-2, 4}));
  }
}

/// Liquid of density 1 and sound 10 m/s on a lattice between a floor at 0 and a ceiling, periodic in x; h = 2 dx.
struct Channel {
  Parameters base = NoForces();
  ParametersSPH sph;

  Channel(WallKind kind, double width, double height, double spacing) {
    base.fluid.region.box = {0, 0, width, height};
    base.fluid.particles = static_cast<std::size_t>(std::lround(width * height / (spacing * spacing)));
    base.fluid.arrange = Arrangement::kLattice;
    base.particle_mass = spacing * spacing;
    base.threads = 1;
    base.walls = {At(FluidSide::kAbove, 0), At(FluidSide::kBelow, height)};
    base.walls[1].name = "ceiling";
    base.wall.kind = kind;
    base.wall.no_slip = true;
    sph.smoothing_length = 2 * spacing;
    sph.equation_of_state = IdealGas{100, 1};
    sph.periods = {base.fluid.region.box, true, false};
    sph.delta.diffusion = 0;
  }
};

TEST(StickingWalls, LeaveAFlowWithoutDivergenceItsDensity) {
  constexpr double kSpacing = 1.0 / 32;
  Channel channel(WallKind::kMirror, 1, 1, kSpacing);
  channel.base.time_step = 1e-5;
  // Of the stream function sin^2(pi y) sin(2 pi x)/pi: at rest at both walls, with gradients up to 2 pi.
  GivenLiquid system(channel.base, channel.sph, [](Vec2 x) {
    const double sine = std::sin(pi * x.y);
    return Vec2{std::sin(2 * pi * x.y) * std::sin(2 * pi * x.x), -2 * sine * sine * std::cos(2 * pi * x.x)};
  });
  system.Step();
  system.ComputeFields();
  double worst = 0;
  for (const double density : system.Density()) worst = std::max(worst, std::abs(density - 1) / 1e-5);
  EXPECT_LT(worst, 0.01 * 2 * pi) << "the lattice's own error is half of that; velocities turned round give 0.5";
}

class StickingWallsOf : public testing::TestWithParam<WallKind> {};
INSTANTIATE_TEST_SUITE_P(BothKinds, StickingWallsOf, testing::Values(WallKind::kMirror, WallKind::kParticles));

/// Stokes' second problem [H. Schlichting, Boundary-Layer Theory, section V.7]: over a floor with the velocity U sin(wt
/// + phase) the fluid has U exp(-k y) sin(wt + phase - k y), k = sqrt(w/(2 nu)).
TEST_P(StickingWallsOf, DragTheFluidAboveAFloorThatGoesToAndFro) {
  constexpr double kPerLength = 1, kSpeed = 0.5, kFrequency = 1, kPhase = 0.7;  // [1/m, m/s, Hz, rad]
  Channel channel(GetParam(), 3, 6, 1.0 / 8);  // exp(-6) of the speed is left at the ceiling
  channel.base.walls[0].tangential = {0, kSpeed, kFrequency, kPhase};
  channel.sph.viscosity = pi * kFrequency / (kPerLength * kPerLength);
  channel.sph.delta.viscous_form = GetParam() == WallKind::kMirror ? ViscousForm::kLaplacian : ViscousForm::kStress;
  channel.base.time_step = 5e-4;
  double time = 0;
  const auto exact = [&](Vec2 x) {
    const double down = kPerLength * x.y;
    return Vec2{kSpeed * std::exp(-down) * std::sin(2 * pi * kFrequency * time + kPhase - down), 0};
  };
  GivenLiquid system(channel.base, channel.sph, exact);
  double worst = 0;
  for (int eighth = 1; eighth <= 8; ++eighth) {
    while (system.Steps() < 250 * eighth && !system.Trouble()) system.Step();
    ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
    time = system.Time();
    const Particles& p = system.State();
    for (std::size_t i = 0; i < p.Size(); ++i) worst = std::max(worst, Length(p.Velocity(i) - exact(p.Position(i))));
  }
  EXPECT_LT(worst, (GetParam() == WallKind::kMirror ? 0.01 : 0.02) * kSpeed) << "with 8 spacings in a 1/k";
}

TEST_P(StickingWallsOf, DragTheFluidThatSlipsAlongTheOtherOneUntilAllMovesAlike) {
  Channel channel(GetParam(), 1, 0.75, 1.0 / 32);
  channel.base.walls[0].tangential.mean = 0.3;
  channel.base.walls[1].no_slip = false;
  channel.sph.viscosity = 1;
  channel.base.time_step = 1e-4;
  GivenLiquid system(channel.base, channel.sph, [](Vec2) { return Vec2{0.3, 0}; });
  for (int k = 0; k < 100 && !system.Trouble(); ++k) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
  const Particles& p = system.State();
  for (std::size_t i = 0; i < p.Size(); ++i) ASSERT_LT(Length(p.Velocity(i) - Vec2{0.3, 0}), 1e-9);
}

/// A lid that is pulled across a box from rest: what mirrors with antisymmetric velocities in the density do not
/// survive.
TEST_P(StickingWallsOf, HoldADrivenCavityTogether) {
  constexpr double kSpacing = 1.0 / 24;
  Channel channel(GetParam(), 1, 1, kSpacing);
  channel.sph.periods = {};
  channel.base.walls[1].tangential.mean = 1;
  channel.base.walls.push_back(At(FluidSide::kRight, 0));
  channel.base.walls.push_back(At(FluidSide::kLeft, 1));
  channel.sph.viscosity = 0.01;
  channel.sph.delta.diffusion = 0.1;
  channel.base.time_step = 0.01;
  channel.base.adaptive_step = true;
  GivenLiquid system(channel.base, channel.sph, [](Vec2) { return Vec2{}; });
  while (system.Time() < 3 && !system.Trouble()) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
  const auto density = system.Density();
  EXPECT_GT(*std::ranges::min_element(density), 0.95);
  EXPECT_LT(*std::ranges::max_element(density), 1.05);
  double fastest = 0;
  const Particles& p = system.State();
  for (std::size_t i = 0; i < p.Size(); ++i) fastest = std::max(fastest, Length(p.Velocity(i)));
  EXPECT_LT(fastest, 1) << "the lid's";
  EXPECT_GT(fastest, 0.5);
}

}  // namespace
}  // namespace sph
