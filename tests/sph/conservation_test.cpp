// A toy star without damping: with P = k rho^2 and a constant h, eq. 10 is the gradient of an exact pair potential,
// H = sum p^2/2m + k sum_ij m_i m_j W_ij + lambda/2 sum m x^2, so that energy, momenta and reversibility test the
// integrator alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/diagnostics.hpp"
#include "sph/given_system.hpp"
#include "sph/toy_star.hpp"

namespace sph {
namespace {

const ToyStar kStar{2.0, 0.75, 0.1};
constexpr double kSpacing = 0.06;

/// 490 particles on a lattice in the star's disk, in motion with the velocity (ux + turn y, -turn x).
Cloud Start(double ux, double turn) {
  Cloud cloud;
  for (int row = -13; row <= 13; ++row) {
    for (int column = -13; column <= 13; ++column) {
      const Vec2 x{kSpacing * (column + 0.25), kSpacing * row};
      if (Length(x) > kStar.radius) continue;
      cloud.x.push_back(x.x);
      cloud.y.push_back(x.y);
      cloud.vx.push_back(ux + turn * x.y);
      cloud.vy.push_back(-turn * x.x);
    }
  }
  cloud.mass.assign(cloud.x.size(), kStar.mass / static_cast<double>(cloud.x.size()));
  return cloud;
}

GivenSystem Star(double time_step, const Cloud& start) {
  Parameters base = NoForces();
  base.time_step = time_step;
  base.central_force = kStar.CentralForce();
  return {base, {1.3 * kSpacing, Polytrope{kStar.k}, 0, false}, start};
}

/// Half the period of a breathing mode, pi/sqrt(lambda) (METHODS: at any amplitude) [s].
double HalfAPeriod() { return 0.5 * std::numbers::pi / std::sqrt(kStar.CentralForce()); }

/// Greatest |E - E(0)|/E(0) over half a period of breathing.
double EnergyError(double time_step) {
  GivenSystem star = Star(time_step, Start(0, 0));
  const auto energy = [&] {
    star.ComputeFields();
    const Diagnostics d = Diagnose(star);
    return d.kinetic_energy + d.potential_energy + d.internal_energy;
  };
  const double start = energy();
  double greatest = 0;
  while (star.Time() < HalfAPeriod()) {
    star.Step();
    greatest = std::max(greatest, std::abs(energy() / start - 1));
  }
  return greatest;
}

TEST(LeapFrog, KeepsTheEnergyOfAnUndampedStarToSecondOrder) {
  const double coarse = EnergyError(0.008);
  const double fine = EnergyError(0.004);
  EXPECT_LT(fine, 1e-4);  // 1e-5 is measured with c dt/h of 0.3 (METHODS); ours is 0.04
  EXPECT_NEAR(std::log2(coarse / fine), 2.0,
              0.25);  // halving the step quarters the error; what is left is of fourth order
}

TEST(LeapFrog, RetracesItsStepsBackwards) {
  const Cloud start = Start(0, 0.2);
  GivenSystem star = Star(0.004, start);
  const int steps = static_cast<int>(HalfAPeriod() / 0.004);
  for (int k = 0; k < steps; ++k) star.Step();
  star.TurnRound();
  for (int k = 0; k < steps; ++k) star.Step();
  double greatest = 0;
  const Particles& p = star.State();
  for (std::size_t i = 0; i < p.Size(); ++i) {
    greatest = std::max(greatest, Length(p.Position(i) - Vec2{start.x[p.id[i]], start.y[p.id[i]]}));
  }
  // Round-off, which particles that collide magnify: 1e-15 R is measured over half a period, 2e-13 R over two
  // (METHODS).
  EXPECT_LT(greatest, 1e-12 * kStar.radius);
}

TEST(LeapFrog, KeepsAngularMomentumToRoundOff) {
  GivenSystem star = Star(0.004, Start(0, 0.5));
  const auto angular_momentum = [&] {  // x and v half a step apart: the step along v does not change x cross v
    const Particles& p = star.State();
    double sum = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) sum += p.mass[i] * (p.x[i] * p.vy_prev[i] - p.y[i] * p.vx_prev[i]);
    return sum;
  };
  const double start = angular_momentum();
  ASSERT_LT(start, -0.1);
  for (int k = 0; k < 200; ++k) star.Step();
  EXPECT_NEAR(angular_momentum() / start, 1, 1e-12);  // 200 steps of 500 particles, with round-offs of either sign
}

TEST(LeapFrog, MovesTheStarsCentreAsItMovesASingleParticle) {
  // Pressure conserves momentum and the central force is linear, so the centre of mass is an oscillator of its own (eq.
  // 19).
  GivenSystem star = Star(0.004, Start(0.3, 0));
  const Diagnostics d = Diagnose(star);
  Cloud centre;
  centre.x = {d.centre_of_mass.x};
  centre.y = {d.centre_of_mass.y};
  centre.vx = {0.3};
  centre.vy = {0};
  centre.mass = {1};
  GivenSystem particle = Star(0.004, centre);
  for (int k = 0; k < 200; ++k) {
    star.Step();
    particle.Step();
  }
  const Vec2 apart = Diagnose(star).centre_of_mass - particle.State().Position(0);
  EXPECT_LT(Length(apart), 1e-12);
}

}  // namespace
}  // namespace sph
