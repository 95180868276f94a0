// How the accurate solver's particles shift and what that does to their densities, how densities are tied to the room
// that particles have, and the size of the pressure's gradient: whole steps of small systems.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "base/random.hpp"
#include "sph/delta.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_delta_twins.hpp"

namespace sph {
namespace {

constexpr int kAcross = 20;
constexpr double kRho0 = 2;  // [kg/m^3]

/// A square of kAcross x kAcross particles around the origin, `spacing` apart and moved by up to `jitter` spacings,
/// h = 2 spacings; hardly any sound, so that nothing but what a test sets moves them.
struct Square {
  double spacing = 0.05, jitter = 0.25;
  double sound = 1e-10;  // [m/s]
  double crowding = 1;   // mass over that of the reference density on the lattice
  std::function<Vec2(Vec2)> velocity = [](Vec2) { return Vec2{}; };
  std::function<double(Vec2)> density = [](Vec2) { return kRho0; };
  bool periodic = false;
  bool hexagonal = false;
  Parameters base = NoForces();
  ParametersSPH sph;

  Square() {
    sph.delta.diffusion = 0;
    sph.delta.sound_damping = 0;
  }
  std::unique_ptr<Delta> Make() {
    auto given = std::make_shared<GivenStart>();
    Random random(11);
    const double pitch = hexagonal ? std::sqrt(2 / std::numbers::sqrt3) : 1, half = 0.5 * kAcross * spacing;
    for (int row = 0; row < kAcross; ++row) {
      for (int column = 0; column < kAcross; ++column) {
        const Vec2 site{(column + 0.5 + (hexagonal ? 0.5 * (row % 2) : 0)) * pitch, (row + 0.5) / pitch};
        const Vec2 moved = site + jitter * Vec2{random.Uniform(-1, 1), random.Uniform(-1, 1)};
        const Vec2 x = spacing * moved - Vec2{half, half};
        given->particles.Add(x, velocity(x), crowding * kRho0 * spacing * spacing);
        given->density.push_back(density(x));
      }
    }
    base.given = given;
    base.fluid.region.box = {-half, -half, half, half};
    base.fluid.particles = kAcross * kAcross;
    base.particle_mass = kRho0 * spacing * spacing;
    sph.smoothing_length = 2 * spacing;
    sph.equation_of_state = IdealGas{sound * sound, kRho0};
    if (periodic) sph.periods = {{-half, -half, half, half}, true, true};
    auto system = std::make_unique<Delta>(base, sph);
    system->Reset();
    return system;
  }
  Vec2 Start(std::uint32_t id) const { return base.given->particles.Position(id); }
  /// Whether a support around it lies within the square.
  bool IsInside(Vec2 x) const {
    return std::max(std::abs(x.x), std::abs(x.y)) < 0.5 * kAcross * spacing - 2 * sph.smoothing_length;
  }
};

void Advance(Delta& system, int steps) {
  for (int k = 0; k < steps; ++k) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
}

/// By how much each particle, by number, is not where its velocity at the start brought it.
std::vector<Vec2> Shifts(const Square& square, const Delta& system) {
  std::vector<Vec2> shifts(system.State().Size());
  const Particles& p = system.State();
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 start = square.Start(p.id[i]);
    shifts[p.id[i]] = p.Position(i) - start - system.Time() * square.velocity(start);
  }
  return shifts;
}
double Greatest(const std::vector<Vec2>& shifts) {
  double greatest = 0;
  for (const Vec2 shift : shifts) greatest = std::max(greatest, Length(shift));
  return greatest;
}

/// A shear that moves nothing far: what it does in a step is of second order in this [1/s].
constexpr double kShear = 1e-4;
Vec2 Shear(Vec2 x) { return {kShear * x.y, 0}; }

TEST(Shifting, LeavesALinearDensityTheFunctionOfThePlaceThatItWas) {
  constexpr double kSlope = 0.1;  // [kg/m^4], across the shear, which leaves it alone
  for (const bool shifting : {true, false}) {
    Square square;
    square.velocity = Shear;
    square.density = [](Vec2 x) { return kRho0 + kSlope * x.y; };
    square.sph.delta.shifting = shifting;
    const auto system = square.Make();
    Advance(*system, 2);  // strain is known after the first
    system->ComputeFields();
    const Particles& p = system->State();
    const auto density = system->Density();
    double farthest = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const Vec2 start = square.Start(p.id[i]);
      if (!square.IsInside(start)) continue;
      farthest = std::max(farthest, std::abs(p.y[i] - start.y));
      // The rest is the shift's divergence times the strain, of the square of kShear.
      EXPECT_NEAR(density[i], kRho0 + kSlope * p.y[i], 1e-13) << p.id[i];
    }
    if (shifting) {
      EXPECT_GT(kSlope * farthest, 1e-11) << "a hundred times what densities may be off by";
    } else {
      EXPECT_LT(farthest, 1e-16);
    }
  }
}

TEST(Shifting, GoesByStrainAndVanishesInWaterThatIsAtRestOrDrifts) {
  for (const Vec2 drift : {Vec2{}, Vec2{3, -2}}) {
    Square square;
    square.velocity = [&](Vec2) { return drift; };
    const auto system = square.Make();
    Advance(*system, 10);
    EXPECT_LT(Greatest(Shifts(square, *system)), 1e-15) << "round-off of positions";
  }
  const auto greatest = [](double shear) {
    Square square;
    square.velocity = [&](Vec2 x) { return Vec2{shear * x.y, 0}; };
    const auto system = square.Make();
    Advance(*system, 2);
    return Greatest(Shifts(square, *system));
  };
  EXPECT_NEAR(greatest(2e-3) / greatest(1e-3), 2, 1e-5) << "the second step's strain is a little more";
  EXPECT_NEAR(greatest(300) / 0.05, 0.05, 1e-12) << "a twentieth of a spacing at most";
}

TEST(Shifting, OfTheSameFlowIsInProportionToTheSpacing) {
  const auto shifts = [](double spacing) {
    Square square;
    square.spacing = spacing;
    square.velocity = Shear;
    const auto system = square.Make();
    Advance(*system, 2);
    return Shifts(square, *system);
  };
  const auto coarse = shifts(0.05), fine = shifts(0.025);
  const double scale = Greatest(coarse);
  EXPECT_GT(scale, 1e-9);
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_LT(Length(coarse[i] - 2 * fine[i]), 1e-5 * scale) << i;
}

TEST(Shifting, IsTheStrainTimesWhatTheTwinsSumsSay) {
  Square square;
  square.velocity = Shear;
  const auto system = square.Make();
  Advance(*system, 2);
  const auto shifts = Shifts(square, *system);
  Cloud cloud;
  for (std::uint32_t i = 0; i < shifts.size(); ++i) {
    cloud.x.push_back(square.Start(i).x);
    cloud.y.push_back(square.Start(i).y);
    const Vec2 v = Shear(square.Start(i));
    cloud.vx.push_back(v.x);
    cloud.vy.push_back(v.y);
    cloud.mass.push_back(square.base.particle_mass);
  }
  PlainWater water;
  water.h = square.sph.smoothing_length;
  water.rho0 = kRho0;
  water.spacing = square.spacing;
  for (auto* values : {&water.excess, &water.pressure, &water.gradient_x, &water.gradient_y, &water.wholeness}) {
    values->assign(cloud.Size(), 0);
  }
  water.variance = VarianceOf(water.kernel, water.h);
  const auto rates = PlainDensityRates(cloud, water);
  const auto around = SurroundingsOf(cloud, water);
  const double sound = std::visit([](const auto& of) { return of.SoundSpeed(kRho0); }, square.sph.equation_of_state);
  int inside = 0;
  for (std::uint32_t i = 0; i < shifts.size(); ++i) {
    if (!square.IsInside(square.Start(i)) || !square.IsInside(2 * square.Start(i))) continue;
    const double support = 2 * water.h;
    const double factor = -7 * support * support * rates[i].strain * square.base.time_step;
    const double restless = std::min(1.0, rates[i].strain * support / (0.02 * sound));
    const Vec2 expected = factor * (around[i].lack.value + 2 * restless * around[i].near.value);
    EXPECT_LT(Length(shifts[i] - expected), 1e-5 * std::abs(factor) / support) << i;
    ++inside;
  }
  EXPECT_GT(inside, 20);
}

TEST(Shifting, PushesAClosePairApartAndKeepsMomentum) {
  Square square;
  square.jitter = 0.45;  // some are closer than half a spacing
  square.sound = 10;
  square.periodic = true;
  square.base.time_step = 1e-3;
  square.velocity = [](Vec2 x) { return Vec2{std::sin(2 * std::numbers::pi * x.y), 0.3}; };
  const auto least_distance = [](const Delta& system) {
    const Particles& p = system.State();
    double least = 1;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Vec2 d = p.Position(i) - p.Position(j);
        least = std::min(least, std::hypot(d.x - std::round(d.x), d.y - std::round(d.y)));
      }
    }
    return least;
  };
  const auto momentum = [](const Delta& system) {
    const Particles& p = system.State();
    Vec2 sum;
    for (std::size_t i = 0; i < p.Size(); ++i) sum = sum + p.mass[i] * Vec2{p.vx_prev[i], p.vy_prev[i]};
    return sum;
  };
  double least[2];
  for (const bool shifting : {false, true}) {
    square.sph.delta.shifting = shifting;
    const auto system = square.Make();
    EXPECT_LT(least_distance(*system), 0.4 * square.spacing);
    const Vec2 before = momentum(*system);
    Advance(*system, 150);
    EXPECT_LT(Length(momentum(*system) - before), 1e-12);
    least[shifting] = least_distance(*system);
  }
  EXPECT_GT(least[true], 0.5 * square.spacing);
  EXPECT_GT(least[true], 1.2 * least[false]);
}

/// sum W V over a lattice of unit volumes for a support of four spacings.
double Concentration(bool hexagonal) {
  const double pitch = hexagonal ? std::sqrt(2 / std::numbers::sqrt3) : 1;
  double sum = 0;
  for (int row = -6; row <= 6; ++row) {
    for (int column = -9; column <= 9; ++column) {
      const Vec2 x{(column + (hexagonal ? 0.5 * row : 0)) * pitch, row / pitch};
      sum += ValueAt(SmoothingKernel::kWendlandC2, 2, Length(x));
    }
  }
  return sum;
}

TEST(TiedDensities, ComeBackToTheRoomThatParticlesHaveAtTheirRate) {
  constexpr double kSound = 10, kPart = 0.002;
  const double home = kRho0 * Concentration(false) / (0.5 * (Concentration(false) + Concentration(true)));
  for (const double off : {-0.02, 0.01}) {
    Square square;
    square.jitter = 0;
    square.sound = kSound;
    square.periodic = true;
    square.density = [&](Vec2) { return home + off; };
    const auto system = square.Make();
    const double rate = kPart * kSound / (4 * square.spacing);
    for (const int steps : {1, 200, 1000}) {
      Advance(*system, steps - static_cast<int>(system->Steps()));
      system->ComputeFields();
      const double left = off * std::exp(-rate * system->Time());
      for (const double density : system->Density()) {
        // A step takes a share of rate dt = 1e-4, not 1 - exp(-rate dt).
        ASSERT_NEAR(density - home, left, 1e-4 * rate * system->Time() * std::abs(off)) << steps;
      }
    }
  }
}

TEST(TiedDensities, LeaveASurfaceAlone) {
  Square square;
  square.jitter = 0;
  square.sound = 10;
  square.crowding = 1.01;  // without pressure, as densities do not know of it
  const auto system = square.Make();
  Advance(*system, 1);
  system->ComputeFields();
  const Particles& p = system->State();
  const auto density = system->Density();
  int tied = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 x = square.Start(p.id[i]);
    const bool changed = density[i] > kRho0 * (1 + 1e-7);
    if (std::max(std::abs(x.x), std::abs(x.y)) > 0.5 - 4 * square.spacing) {
      EXPECT_FALSE(changed) << p.id[i];
    }
    tied += changed;
  }
  EXPECT_GT(tied, 50);
}

TEST(PressureGradient, HasItsSizeInTheMeanOfSquareAndHexagonalLattices) {
  constexpr double kSound = 10, kSlope = 1e-6;
  for (const SmoothingKernel kernel : kAllKernels) {
    for (const bool sharp : {false, true}) {
      double sum = 0;
      for (const bool hexagonal : {false, true}) {
        Square square;
        square.jitter = 0;
        square.sound = kSound;
        square.hexagonal = hexagonal;
        square.density = [](Vec2 x) { return kRho0 + kSlope * x.y; };
        square.sph.delta.kernel = kernel;
        square.sph.delta.sharp_gradient = sharp;
        const auto system = square.Make();
        const Particles& p = system->State();
        std::size_t middle = 0;
        for (std::size_t i = 0; i < p.Size(); ++i) {
          if (Length(p.Position(i)) < Length(p.Position(middle))) middle = i;
        }
        sum += p.ay[middle] / (-kSound * kSound * kSlope / kRho0);
      }
      EXPECT_NEAR(0.5 * sum, 1, 1e-5) << static_cast<int>(kernel) << ", " << sharp;
    }
  }
}

}  // namespace
}  // namespace sph
