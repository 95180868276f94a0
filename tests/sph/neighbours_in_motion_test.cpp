// Lists and notes that outlive a step must not outlive what makes them true: sorting, walls that jump, drops, another
// support.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

const Polytrope kThinGas{1e-30};  // so thin that every particle moves by itself

/// `n` particles at random in the unit square, moving in all directions at up to `speed`.
Cloud Swarm(std::size_t n, double speed) {
  Random random(3);
  Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    cloud.x.push_back(random.Uniform());
    cloud.y.push_back(random.Uniform());
    cloud.vx.push_back(random.Uniform(-speed, speed));
    cloud.vy.push_back(random.Uniform(-speed, speed));
  }
  cloud.mass.assign(n, 1.0 / static_cast<double>(n));
  return cloud;
}

/// Walls around the unit square.
Parameters InASquare(std::size_t n) {
  Parameters base = NoForces();
  base.threads = 1;
  base.fluid.particles = n;  // says how far apart they are
  base.walls = {{"left", FluidSide::kRight, 0, 0, 0, 0},
                {"right", FluidSide::kLeft, 1, 0, 0, 1},
                {"floor", FluidSide::kAbove, 0, 0, 0, 0},
                {"ceiling", FluidSide::kBelow, 1, 0, 1, 1}};
  return base;
}

/// Greatest difference between the system's density and the sum over all pairs, over the greatest density.
double DensityError(const GivenSystem& system) {
  const auto plain = PlainDensity(CloudOf(system), system.parameters_sph.smoothing_length);
  const auto density = system.Density();
  double error = 0, greatest = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    error = std::max(error, std::abs(density[i] - plain[i].value.x));
    greatest = std::max(greatest, plain[i].value.x);
  }
  return error / greatest;
}

constexpr double kRoundOff = 1e-12;  // of sums of some ten terms; a missed pair costs far more

TEST(NeighboursInMotion, SortingTheParticlesLosesNoWallForce) {
  // The plain particle system never sorts: in so thin a gas each particle has to follow its course there.
  constexpr std::size_t kParticles = 3000;
  const Cloud swarm = Swarm(kParticles, 2);
  Parameters base = InASquare(kParticles);
  base.wall.stiffness = 20000;
  base.wall.damping = 50;
  class Plain : public ParticleSystem {
   public:
    Plain(const Parameters& p, Cloud start) : ParticleSystem(p), start_(std::move(start)) { Reset(); }

   protected:
    void InitialPositions() override {
      for (std::size_t i = 0; i < start_.Size(); ++i) {
        particles_.Add({start_.x[i], start_.y[i]}, {start_.vx[i], start_.vy[i]}, start_.mass[i]);
      }
    }

   private:
    Cloud start_;
  } plain(base, swarm);
  GivenSystem sorted(base, {0.025, kThinGas}, swarm);
  for (int k = 0; k < 300; ++k) {
    plain.Step();
    sorted.Step();
  }
  ASSERT_GT(sorted.Neighbours().Sorts(), 2) << "nothing was sorted on the way";
  double apart = 0;
  const Particles& p = sorted.State();
  for (std::size_t i = 0; i < p.Size(); ++i) {
    apart = std::max(apart, Length(p.Position(i) - plain.State().Position(p.id[i])));
  }
  EXPECT_LT(apart, 1e-9);  // round-off of 300 steps; a step without its wall force is 1e-3 or more
}

TEST(NeighboursInMotion, DensityIsThatOfAllPairsAtEveryStep) {
  GivenSystem system(InASquare(400), {0.06, kThinGas}, Swarm(400, 1));
  for (int k = 0; k < 100; ++k) {
    system.Step();
    system.ComputeFields();
    ASSERT_LT(DensityError(system), kRoundOff) << "step " << k;
  }
  EXPECT_LT(system.Neighbours().ListsMade(), 100) << "made anew every time: that they hold has not been tried";
}

TEST(NeighboursInMotion, AReflectingWallThatJumpsTakesTheNeighboursAlong) {
  // Particles at rest: nothing that they do makes the lists anew. The wall sweeps a third of them onto its line.
  Parameters base = InASquare(400);
  base.wall.kind = WallKind::kReflect;
  GivenSystem system(base, {0.06, kThinGas}, Swarm(400, 0));
  system.Step();
  system.parameters.walls[1].at = 0.7;
  system.Step();
  system.ComputeFields();
  EXPECT_LT(DensityError(system), kRoundOff);
}

TEST(NeighboursInMotion, AReflectingWallThatAdvancesTakesTheNeighboursAlong) {
  Parameters base = InASquare(400);
  base.wall.kind = WallKind::kReflect;
  base.walls[1].velocity = -2;
  GivenSystem system(base, {0.06, kThinGas}, Swarm(400, 0));
  for (int k = 0; k < 100; ++k) {
    system.Step();
    system.ComputeFields();
    ASSERT_LT(DensityError(system), kRoundOff) << "step " << k;
  }
}

TEST(NeighboursInMotion, ClustersThatFlyApartAreCutAnew) {
  // Halves of one cluster, which go opposite ways without a sort's being due for the length of the lists: 16 supports
  // apart, coordinates in float are the same again.
  Cloud halves;
  for (int k = 0; k < 8; ++k) {
    halves.x.push_back(0.02 * (k % 4));
    halves.y.push_back(0.02 * (k / 4));
    halves.vx.push_back(k % 4 < 2 ? -5 : 5);
    halves.vy.push_back(0);
    halves.mass.push_back(1);
  }
  Parameters base = NoForces();
  base.threads = 1;
  base.fluid.particles = 8;
  GivenSystem system(base, {.smoothing_length = 0.06, .equation_of_state = kThinGas, .precision = Precision::kFloat},
                     halves);
  double furthest = 0;  // [supports]
  while (furthest < 17) {
    system.Step();
    system.ComputeFields();
    furthest = 10 * system.Time() / 0.12;
    ASSERT_LT(DensityError(system), 1e-5) << furthest << " supports apart";
  }
}

TEST(NeighboursInMotion, AnotherSmoothingLengthTakesEffectAtOnce) {
  GivenSystem system(InASquare(400), {0.03, kThinGas}, Swarm(400, 1));
  for (const double h : {0.06, 0.02, 0.05}) {
    system.parameters_sph.smoothing_length = h;
    system.ComputeFields();
    EXPECT_LT(DensityError(system), kRoundOff) << h;
  }
}

}  // namespace
}  // namespace sph
