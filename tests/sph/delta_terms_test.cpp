// What the accurate solver does to a liquid beside pressure: viscosity in its two forms, the damping of sound, friction
// and slip along walls, against what is known of each; and that without them it can go back the way it came.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "particles/diagnostics.hpp"
#include "sph/delta.hpp"
#include "sph/given_system.hpp"

namespace sph {
namespace {

using std::numbers::pi;

constexpr int kAcross = 32;
constexpr double kSound = 10;  // [m/s]
const Box kTile{0, 0, 1, 1};   // [m]

/// A square metre of water, 32 x 32 particles on a lattice with h = 2.8 dx, with nothing but pressure.
struct Water {
  Parameters base = NoForces();
  ParametersSPH sph;

  Water() {
    base.fluid.particles = kAcross * kAcross;
    base.fluid.region.box = kTile;
    base.fluid.arrange = Arrangement::kLattice;
    base.particle_mass = 1.0 / (kAcross * kAcross);
    base.time_step = 1e-3;
    base.threads = 1;
    sph.smoothing_length = 2.8 / kAcross;
    sph.equation_of_state = IdealGas{kSound * kSound, 1};
    sph.delta.diffusion = 0;
    sph.delta.sound_damping = 0;
    sph.delta.shifting = false;
    sph.delta.tensile_control = false;
  }
};
Water PeriodicWater() {
  Water water;
  water.sph.periods = {kTile, true, true};
  return water;
}

/// A shear wave, and a sound wave, both of wave number 2 pi.
Vec2 Shear(Vec2 x) { return {0.1 * std::sin(2 * pi * x.y), 0}; }
Vec2 Sound(Vec2 x) { return {0.1 * std::sin(2 * pi * x.x), 0}; }

void Advance(ParticleSystem& system, double time) {
  while (system.Time() < time && !system.Trouble()) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
}

/// Sum over a lattice of V (-W'/r) term(x, y), but for the particle itself: what the passes make of a wave.
double LatticeSum(const std::function<double(Vec2)>& term) {
  const WendlandC2 kernel(2.8 / kAcross);
  double sum = 0;
  for (int row = -6; row <= 6; ++row) {
    for (int column = -6; column <= 6; ++column) {
      const Vec2 x{static_cast<double>(column) / kAcross, static_cast<double>(row) / kAcross};
      if (row != 0 || column != 0) sum -= kernel.Gradient(Length(x)) * term(x) / (kAcross * kAcross);
    }
  }
  return sum;
}

double KineticEnergy(const ParticleSystem& system) { return Diagnose(system).kinetic_energy; }

TEST(DeltaTerms, BothFormsOfViscosityWearAShearWaveDownAtItsRate) {
  constexpr double kNu = 0.05;  // [m^2/s]
  // Forces of 8 nu (u_j - u_i).r r/r^2 between particles, of which the part along the wave's velocity acts on it.
  const double stress = 8 * LatticeSum([](Vec2 x) { return x.x * x.x / Dot(x, x) * (1 - std::cos(2 * pi * x.y)); });
  EXPECT_NEAR(stress / (4 * pi * pi), 1, 0.03);  // of order (kh)^2, with kh = 0.55
  for (const ViscousForm form : {ViscousForm::kLaplacian, ViscousForm::kStress}) {
    Water water = PeriodicWater();
    water.sph.viscosity = kNu;
    water.sph.delta.viscous_form = form;
    GivenLiquid system(water.base, water.sph, Shear);
    const double start = KineticEnergy(system);
    Advance(system, 0.2);
    const double rate = -std::log(KineticEnergy(system) / start) / system.Time();
    EXPECT_NEAR(rate / (2 * kNu * (form == ViscousForm::kStress ? stress : 4 * pi * pi)), 1, 0.004);
  }
}

TEST(DeltaTerms, StressesLeaveADropThatTurnsLikeARigidBodyAloneTheLaplacianDoesNot) {
  const auto kept = [](ViscousForm form) {
    Water water;
    water.base.fluid.region.box = {-0.5, -0.5, 0.5, 0.5};
    water.sph.viscosity = 0.05;
    water.sph.delta.viscous_form = form;
    GivenLiquid system(water.base, water.sph, [](Vec2 x) { return Vec2{-x.y, x.x}; });
    const auto momentum = [&] {  // with the velocities half a step before, of which leapfrog keeps every digit
      const Particles& p = system.State();
      double sum = 0;
      for (std::size_t i = 0; i < p.Size(); ++i) sum += p.mass[i] * (p.x[i] * p.vy_prev[i] - p.y[i] * p.vx_prev[i]);
      return sum;
    };
    const double start = momentum();
    for (int k = 0; k < 50; ++k) system.Step();
    return momentum() / start;
  };
  EXPECT_NEAR(kept(ViscousForm::kStress), 1, 1e-12);
  EXPECT_GT(std::abs(kept(ViscousForm::kLaplacian) - 1), 1e-3);
}

TEST(DeltaTerms, DampingOfSoundWearsASoundWaveDownAtItsRateAndLeavesShearAlone) {
  // u'' = c^2 lap u + alpha h c lap u' makes amplitudes fall as exp(-alpha h c k^2 t/2).
  constexpr double kAlpha = 0.5;
  const auto after = [](double alpha, Vec2 (*flow)(Vec2), double time) {
    Water water = PeriodicWater();
    water.base.time_step = 5e-4;
    water.sph.delta.sound_damping = alpha;
    GivenLiquid system(water.base, water.sph, flow);
    Advance(system, time);
    return KineticEnergy(system);
  };
  const double period = 1 / kSound;  // [s], of wave length 1 m
  const double reduction = after(kAlpha, Sound, period) / after(0, Sound, period);
  const double k = LatticeSum([](Vec2 x) { return x.x * std::sin(2 * pi * x.x); });  // for the passes' gradients
  EXPECT_NEAR(k / (2 * pi), 1, 0.05);
  const double expected = kAlpha * 2.8 / kAcross * kSound * k * k * period;
  EXPECT_NEAR(-std::log(reduction) / expected, 1, 0.05);  // energy swings twice a period, here at slightly other times
  EXPECT_NEAR(after(kAlpha, Shear, 3 * period) / after(0, Shear, 3 * period), 1, 1e-6);
}

TEST(DeltaTerms, TheStepThatDampingOfSoundAllowsIsStableAndTwiceThatIsNot) {
  const auto greatest_speed = [](double part) {
    Water water = PeriodicWater();
    water.base.fluid.arrange = Arrangement::kPerturbed;
    water.base.fluid.jitter = 0.02 / kAcross;
    water.sph.delta.sound_damping = 1;
    GivenLiquid system(water.base, water.sph, Sound);
    const auto limits = system.StepLimits();
    const auto damping = std::ranges::find(limits, "sound damping", &StepLimit::what);
    const auto sound = std::ranges::find(limits, "speed of sound", &StepLimit::what);
    // (w dt/2)^2 + alpha h c k^2 dt/2 = 1 at the limit of both.
    const double a = std::pow(1 / sound->seconds, 2), b = 1 / damping->seconds;
    system.parameters.time_step = part * (std::sqrt(b * b + 4 * a) - b) / (2 * a);
    for (int k = 0; k < 400 && !system.Trouble(); ++k) system.Step();
    return system.Trouble() ? 1e9 : Diagnose(system).max_speed;
  };
  EXPECT_LT(greatest_speed(0.9), 0.15);  // it begins with 0.1
  EXPECT_GT(greatest_speed(1.8), 10);
}

TEST(DeltaTerms, ABoundaryLayerTakesFromTheFluidWhatItsVelocityProfileSays) {
  constexpr double kNu = 1e-6, kSpeed = 3, kSpacing = 1.0 / kAcross;
  Water water;
  water.sph.periods = {kTile, true, false};
  water.base.walls = {{.name = "floor", .fluid = FluidSide::kAbove, .at = 0},
                      {.name = "cellar", .fluid = FluidSide::kAbove, .at = -0.1 * kSpacing},  // behind the floor
                      {.name = "ceiling", .fluid = FluidSide::kBelow, .at = 1, .no_slip = true}};
  water.base.wall.kind = WallKind::kMirror;
  water.base.wall.layer_viscosity = kNu;
  GivenLiquid system(water.base, water.sph, [](Vec2) { return Vec2{-kSpeed, 0}; });
  // u* from the profile u/u* = 8.3 (u* y/nu)^(1/7) in the middle of the lowest layer, by bisection.
  double low = 0, high = kSpeed;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (middle * 8.3 * std::pow(middle * 0.5 * kSpacing / kNu, 1.0 / 7) < kSpeed ? low : high) = middle;
  }
  double force = 0;
  const Particles& p = system.State();
  for (std::size_t i = 0; i < p.Size(); ++i) force += p.mass[i] * p.ax[i];
  EXPECT_NEAR(force, low * low, 1e-9 * low * low) << "rho u*^2 over a metre, against the motion";
}

TEST(DeltaTerms, AWallThatSlidesDragsTheFluidThatSticksToItAndNoOther) {
  for (const bool sticks : {true, false}) {
    Water water;
    water.sph.viscosity = 1;
    water.base.time_step = 1e-4;
    water.base.walls = {{.name = "left", .fluid = FluidSide::kRight, .at = 0},
                        {.name = "right", .fluid = FluidSide::kLeft, .at = 1, .tangential = {0.3}}};
    water.base.wall.kind = WallKind::kMirror;
    water.base.wall.no_slip = sticks;
    water.sph.periods = {kTile, false, true};
    const auto steady = [&](Vec2 x) { return Vec2{0, sticks ? 0.3 * x.x : 0}; };
    GivenLiquid system(water.base, water.sph, steady);
    Advance(system, 0.02);  // in which viscosity reaches a quarter of a metre from a wall
    double worst = 0;
    const Particles& p = system.State();
    for (std::size_t i = 0; i < p.Size(); ++i) worst = std::max(worst, Length(p.Velocity(i) - steady(p.Position(i))));
    EXPECT_LT(worst, 0.3 * 1e-3);
  }
}

/// The greatest distance of a particle from where it was, in the units of lengths, after `steps` steps, and after as
/// many back.
struct Way {
  double there = 0, back = 0;
};
Way ThereAndBack(GivenLiquid& system, int steps) {
  const auto places = [&] {
    const Particles& p = system.State();
    std::vector<Vec2> by_id(p.Size());
    for (std::size_t i = 0; i < p.Size(); ++i) by_id[p.id[i]] = p.Position(i);
    return by_id;
  };
  const auto apart = [](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    double greatest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vec2 d = a[i] - b[i];  // in a periodic square metre, or far less than that
      greatest = std::max(greatest, std::hypot(d.x - std::round(d.x), d.y - std::round(d.y)));
    }
    return greatest;
  };
  const auto start = places();
  for (int k = 0; k < steps; ++k) system.Step();
  const double there = apart(places(), start);
  system.TurnRound();
  for (int k = 0; k < steps; ++k) system.Step();
  return {there, apart(places(), start)};
}

TEST(DeltaTerms, AGasRetracesItsStepsToRoundOff) {
  Water star;
  star.sph.equation_of_state = Polytrope{0.1};
  star.sph.smoothing_length = 0.11;
  star.base.fluid.particles = 600;
  star.base.fluid.region = {{}, {0, 0}, 0.75};
  star.base.particle_mass = 2.0 / 600;
  star.base.central_force = 1.6;
  star.base.time_step = 0.01;
  GivenLiquid system(star.base, star.sph, [](Vec2 x) { return 0.3 * x; });
  const Way way = ThereAndBack(system, 250);  // a period of 2.5 s
  EXPECT_GT(way.there, 0.02);
  EXPECT_LT(way.back, 1e-12);  // round-off, which particles that approach each other magnify
}

TEST(DeltaTerms, WithoutThemALiquidAlmostRetracesItsSteps) {
  // Rates of density are of the half step, but take density itself from before it: the square of what it changes by in
  // a step is missed in every step, which is of first order, but of a liquid's density small.
  const auto missed = [](int steps) {
    Water water = PeriodicWater();
    water.base.time_step = 0.1 / steps;
    const auto vortices = [](Vec2 x) {
      return Vec2{-std::cos(2 * pi * x.x) * std::sin(2 * pi * x.y), std::sin(2 * pi * x.x) * std::cos(2 * pi * x.y)};
    };
    GivenLiquid system(water.base, water.sph, vortices);
    const Way way = ThereAndBack(system, steps);
    EXPECT_GT(way.there, 0.05);
    return way.back;
  };
  const double coarse = missed(50), middle = missed(100), fine = missed(200);
  EXPECT_LT(fine, 1e-4);
  // Densities are tied to the room of the particles whichever way they go, and by a time, not by a step.
  EXPECT_GT((coarse - middle) / (middle - fine), 1.9);
}

TEST(DeltaTerms, PressureKeepsTheMomentumOfALiquidToRoundOff) {
  Water water = PeriodicWater();
  water.base.fluid.arrange = Arrangement::kPerturbed;
  water.base.fluid.jitter = 0.2 / kAcross;
  water.sph.viscosity = 0.01;
  water.sph.delta.sound_damping = 0.3;
  GivenLiquid system(water.base, water.sph, [](Vec2 x) { return Shear(x) + Sound(x) + Vec2{0.2, -0.1}; });
  const auto momentum = [&] {
    const Particles& p = system.State();
    Vec2 sum;
    for (std::size_t i = 0; i < p.Size(); ++i) sum = sum + p.mass[i] * Vec2{p.vx_prev[i], p.vy_prev[i]};
    return sum;
  };
  const Vec2 start = momentum();
  for (int k = 0; k < 100; ++k) system.Step();
  EXPECT_LT(Length(momentum() - start), 1e-13);  // of 1 kg at 0.2 m/s; a hundred steps with round-off of 1e-16
}

}  // namespace
}  // namespace sph
