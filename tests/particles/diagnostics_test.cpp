// Sums over the particles that are known beforehand.
#include "particles/diagnostics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

struct One {
  Vec2 position, velocity;
  double mass;
};

/// A system of chosen particles, in the order in which they are given.
class Given : public ParticleSystem {
 public:
  Given(const Parameters& base, std::vector<One> start) : ParticleSystem(base), start_(std::move(start)) { Reset(); }
  void Reverse() {
    std::vector<std::uint32_t> order(particles_.Size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint32_t>(order.size() - 1 - k);
    particles_.Reorder(order);
  }

 protected:
  void InitialPositions() override {
    for (const One& s : start_) particles_.Add(s.position, s.velocity, s.mass);
  }

 private:
  std::vector<One> start_;
};

Parameters Base() {
  Parameters base;
  base.fluid.particles = 100;
  base.fluid.region.box = {0, 0, 1, 1};  // spacing 0.1
  base.particle_mass = 1;
  base.time_step = 0.01;
  base.integration = Integration::kSymplecticEuler;
  return base;
}

const std::vector<One> kThree = {{{1, 0}, {0, 2}, 1}, {{-1, 3}, {4, 0}, 2}, {{0, 0}, {0, 0}, 5}};

TEST(Diagnose, SumsEnergiesMomentaAndMassesByHand) {
  Parameters base = Base();
  base.gravity = {0, -10};
  base.central_force = 2;
  const Diagnostics d = Diagnose(Given(base, kThree));
  EXPECT_DOUBLE_EQ(d.kinetic_energy, 0.5 * 4 + 0.5 * 2 * 16);
  EXPECT_DOUBLE_EQ(d.potential_energy, 2 * 10 * 3 + 0.5 * 2 * (1 * 1 + 2 * 10));  // -m g.x + m lambda x^2/2
  EXPECT_EQ(d.internal_energy, 0) << "particles without pressure";
  EXPECT_EQ(d.momentum, (Vec2{8, 2}));
  EXPECT_DOUBLE_EQ(d.angular_momentum, 1 * (1 * 2) + 2 * (-1 * 0 - 3 * 4));
  EXPECT_DOUBLE_EQ(d.centre_of_mass.x, (1 - 2) / 8.0);
  EXPECT_DOUBLE_EQ(d.centre_of_mass.y, 6 / 8.0);
  EXPECT_EQ(d.max_speed, 4);
  EXPECT_EQ(d.bounds, (Box{-1, 0, 1, 3}));
}

TEST(Diagnose, OfNoParticlesIsAllZero) {
  Parameters base = Base();
  const Diagnostics d = Diagnose(Given(base, {}));
  EXPECT_EQ(d.kinetic_energy, 0);
  EXPECT_EQ(d.bounds, Box{});
  EXPECT_EQ(d.centre_of_mass, Vec2{});
}

TEST(Diagnose, HashDoesNotDependOnTheOrderInWhichParticlesAreKept) {
  Given system(Base(), kThree);
  const Diagnostics before = Diagnose(system);
  system.Reverse();
  const Diagnostics after = Diagnose(system);
  EXPECT_EQ(before.state_hash, after.state_hash);
  EXPECT_EQ(before.kinetic_energy, after.kinetic_energy);
}

TEST(Diagnose, HashSeesAnyLastBitAndTheTime) {
  const std::uint64_t hash = Diagnose(Given(Base(), kThree)).state_hash;
  for (int component = 0; component < 4; ++component) {
    auto nudged = kThree;
    One& s = nudged[1];
    double* const numbers[] = {&s.position.x, &s.position.y, &s.velocity.x, &s.velocity.y};
    *numbers[component] = std::nextafter(*numbers[component], 100);
    EXPECT_NE(Diagnose(Given(Base(), nudged)).state_hash, hash) << component;
  }
  const std::vector<One> at_rest = {{{0, 0}, {0, 0}, 1}};
  Given system(Base(), at_rest);
  const std::uint64_t start = Diagnose(system).state_hash;
  system.Step();  // nothing moves, but time passes
  EXPECT_NE(Diagnose(system).state_hash, start);
}

TEST(Diagnose, CountsWhoIsBeyondAWallByMoreThanASpacing) {
  Parameters base = Base();
  base.walls = {{"floor", FluidSide::kAbove, 0, 0, 0, 0}, {"left", FluidSide::kRight, 0, 0, 0, 0}};
  const Given system(base, {{{1, -0.05}, {0, 0}, 1},  // in the floor by half a spacing
                            {{1, -0.15}, {0, 0}, 1},  // through it
                            {{-5, -5}, {0, 0}, 1},    // through two walls: one particle
                            {{1, 1}, {0, 0}, 1},
                            {{1, std::nan("")}, {0, 0}, 1}});  // nowhere is not inside
  EXPECT_EQ(Diagnose(system).outside, 3u);
}

TEST(Diagnose, DeepestIsInSpacings) {
  Parameters base = Base();
  base.walls = {{"floor", FluidSide::kAbove, 0, 0, 0, 0}};
  Given system(base, {{{1, -0.05}, {0, 0}, 1}});
  system.Step();
  EXPECT_NEAR(Diagnose(system).deepest, 0.5, 1e-14);
}

}  // namespace
}  // namespace sph
