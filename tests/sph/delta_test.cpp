// The accurate solver as a whole: what stays, what converges, and what a block that drops in finds.
#include "sph/delta.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/diagnostics.hpp"
#include "sph/given_system.hpp"

namespace sph {
namespace {

const Box kTile{0, 0, 1, 1};  // [m]

const InitialFlow* Flow(const std::string& name) {
  return &*std::ranges::find(AllInitialFlows(), name, &InitialFlow::name);
}

/// A periodic square metre of water, 20 x 20 particles, speed of sound 10 m/s; nothing that wears motion down.
struct Water {
  Parameters base = NoForces();
  ParametersSPH sph;

  Water() {
    base.fluid.particles = 400;
    base.fluid.region.box = kTile;
    base.fluid.arrange = Arrangement::kLattice;
    base.particle_mass = 1.0 / 400;
    base.particle_limit = 1000;
    base.time_step = 2e-3;
    sph.smoothing_length = 0.1;
    sph.equation_of_state = IdealGas{100, 1};
    sph.delta.diffusion = 0;
    sph.delta.sound_damping = 0;
    sph.delta.shifting = false;
    sph.delta.tensile_control = false;
    sph.periods = {kTile, true, true};
  }
  std::unique_ptr<Delta> Make() const {
    auto system = std::make_unique<Delta>(base, sph);
    system->Reset();
    return system;
  }
};

void Advance(Delta& system, int steps) {
  for (int k = 0; k < steps; ++k) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
}

/// Where the particle of each number is, in the box.
std::vector<Vec2> ById(const Delta& system) {
  const Particles& p = system.State();
  std::vector<Vec2> places(p.Size());
  for (std::size_t i = 0; i < p.Size(); ++i) places[p.id[i]] = p.Position(i);
  return places;
}

/// RMS distance, across seams where that is shorter.
double Distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 d = a[i] - b[i];
    squares += std::pow(d.x - std::round(d.x), 2) + std::pow(d.y - std::round(d.y), 2);
  }
  return std::sqrt(squares / static_cast<double>(a.size()));
}

TEST(Delta, WaterThatDriftsThroughThePeriodicBoxStaysWhatItIs) {
  for (const SmoothingKernel kernel : {SmoothingKernel::kWendlandC2, SmoothingKernel::kWendlandC4}) {
    Water water;
    water.base.fluid.velocity = {1.3, -0.7};
    water.sph.delta = DeltaParameters{.kernel = kernel};  // with all that it has
    const auto system = water.Make();
    Advance(*system, 500);  // more than a box's length
    for (std::size_t i = 0; i < 400; ++i) {
      // A lattice has no shift and even pressure no force: round-off of 1e-15 m/s and less a step is left.
      EXPECT_NEAR(system->State().vx[i], 1.3, 1e-10);
      EXPECT_NEAR(system->State().vy[i], -0.7, 1e-10);
      EXPECT_NEAR(system->Density()[i], system->Density()[0], 1e-10);
      EXPECT_NEAR(system->Density()[i], 1, 1e-4);  // it is tied to the lattice's, which is not quite that
    }
  }
}

TEST(Delta, IsOfSecondOrderInTheTimeStep) {
  // Vortices in a square lattice, without what takes gradients from the step before.
  const auto after = [](int steps) {
    Water water;
    water.sph.flow = Flow("taylor-green");
    water.base.time_step = 0.05 / steps;
    const auto system = water.Make();
    Advance(*system, steps);
    return ById(*system);
  };
  const auto coarse = after(25), middle = after(50), fine = after(100);
  const double ratio = Distance(coarse, middle) / Distance(middle, fine);
  EXPECT_GT(ratio, 3.5);  // 4 for the second order
  EXPECT_LT(ratio, 4.5);
}

TEST(Delta, KeepsEnergyWithoutWhatWearsItDown) {
  Water water;
  water.sph.flow = Flow("taylor-green");
  water.base.fluid.arrange = Arrangement::kPerturbed;
  water.base.fluid.jitter = 0.005;
  const auto system = water.Make();
  const auto energy = [&] {
    const Diagnostics d = Diagnose(*system);
    return d.kinetic_energy + d.internal_energy;
  };
  const double before = energy();
  Advance(*system, 200);
  EXPECT_NEAR(energy() / before, 1, 0.05);  // in disorder the divergence is exact rather than the gradient's adjoint
}

TEST(Delta, FloatFollowsDouble) {
  const auto after = [](Precision precision) {
    Water water;
    water.sph.flow = Flow("taylor-green");
    water.base.fluid.arrange = Arrangement::kPerturbed;
    water.base.fluid.jitter = 0.005;
    water.sph.precision = precision;
    water.sph.delta = {};
    const auto system = water.Make();
    Advance(*system, 50);
    return ById(*system);
  };
  const double apart = Distance(after(Precision::kFloat), after(Precision::kDouble));
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, 1e-5);  // 1e-7 of accelerations of about 10 m/s^2 over a tenth of a second, before chaos sets in
}

TEST(Delta, ShiftingMakesTheSpacingMoreEven) {
  const auto least_distance = [](bool shifting) {
    Water water;
    water.sph.flow = Flow("taylor-green");
    water.sph.delta.shifting = shifting;
    const auto system = water.Make();
    Advance(*system, 100);
    const Particles& p = system->State();
    double least = 1;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) least = std::min(least, Length(p.Position(i) - p.Position(j)));
    }
    return least;
  };
  EXPECT_GT(least_distance(true), 1.1 * least_distance(false));
}

TEST(Delta, ABlockThatDropsInHasTheReferenceDensityAndMakesNoTrouble) {
  Water water;
  water.base.fluid.region.box = {0, 0, 1, 0.5};
  water.base.fluid.particles = 200;
  water.base.drop.particles = 25;
  water.base.drop.region.box = {0.3, 0.7, 0.55, 0.95};
  water.base.drop.spacing = 0.05;
  water.sph.periods = {};
  water.sph.delta = {};
  const auto system = water.Make();
  Advance(*system, 20);
  ASSERT_EQ(system->DropBlock(), "");
  system->Step();
  const Particles& p = system->State();
  ASSERT_EQ(p.Size(), 225u);
  const auto density = system->Density();
  for (std::size_t i = 0; i < p.Size(); ++i) {
    if (p.id[i] >= 200) {
      EXPECT_NEAR(density[i], 1, 1e-3);
    }
  }
  Advance(*system, 200);
}

TEST(Delta, ResetStartsTheSameRunAgain) {
  Water water;
  water.sph.flow = Flow("taylor-green");
  water.sph.delta = {};
  const auto system = water.Make();
  Advance(*system, 60);
  const auto first = Diagnose(*system).state_hash;
  Advance(*system, 7);
  system->Reset();
  Advance(*system, 60);
  EXPECT_EQ(Diagnose(*system).state_hash, first);
}

TEST(Delta, LookingAtTheFieldsChangesNothing) {
  Water water;
  water.sph.flow = Flow("rotating-square");  // negative pressure, so that tensile control reads the wholeness
  water.sph.delta = {};
  water.sph.periods = {};  // and a surface, where it changes
  const auto unseen = water.Make();
  const auto seen = water.Make();
  for (int step = 0; step < 40; ++step) {
    unseen->Step();
    seen->Step();
    seen->ComputeFields();
    seen->ComputeFields();
  }
  EXPECT_EQ(Diagnose(*seen).state_hash, Diagnose(*unseen).state_hash);
}

TEST(Delta, SaysWhenTheDensityIsNoLiquidsAnyMore) {
  Water water;
  water.sph.equation_of_state = IdealGas{0.1, 1};  // hardly any pressure against the vortices
  water.sph.flow = Flow("taylor-green");
  water.sph.flow_speed = 0.3;
  const auto system = water.Make();
  for (int k = 0; k < 5000 && !system->Trouble(); ++k) system->Step();
  ASSERT_TRUE(system->Trouble());
  EXPECT_NE(system->Trouble()->limit.find("times that of the liquid at rest"), std::string::npos)
      << system->Trouble()->Message();
  system->Reset();
  system->Step();
  EXPECT_FALSE(system->Trouble());
}

}  // namespace
}  // namespace sph
