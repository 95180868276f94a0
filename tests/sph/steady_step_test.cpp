// A step allocates nothing once lists and arrays have grown to what the flow needs, and its bits do not depend on who
// computes them.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "sph/given_system.hpp"

namespace {
std::atomic<long> allocations = 0;
}  // namespace

// Replace the program's allocation functions by ones that count. The compiler sees one of each pair through and takes
// them for mismatched.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace sph {
namespace {

/// A block of 5000 particles of water that falls and splashes between walls.
struct Splash {
  explicit Splash(Precision precision, int threads) : system(Base(threads), Water(precision)) { system.Reset(); }

  static Parameters Base(int threads) {
    constexpr double kSpacing = 0.02;
    Parameters base = NoForces();
    base.fluid.particles = 5000;
    base.fluid.spacing = kSpacing;
    base.fluid.arrange = Arrangement::kLattice;
    base.fluid.region.box = {0, 0, 2, 1};
    base.particle_mass = kSpacing * kSpacing;
    base.gravity = {0, -1};
    base.walls = {{"left", FluidSide::kRight, 0, 0, 0, 0},
                  {"right", FluidSide::kLeft, 3, 0, 3, 3},
                  {"floor", FluidSide::kAbove, 0, 0, 0, 0}};
    base.wall = {WallKind::kPenalty, 4 / (kSpacing * kSpacing), 1 / kSpacing, 0};
    base.time_step = 0.4 * 1.3 * kSpacing / 10;
    base.threads = threads;
    return base;
  }
  static ParametersSPH Water(Precision precision) {
    ParametersSPH water{0.026, Tait{100.0 / 7, 1, 7}};
    water.precision = precision;
    return water;
  }

  ParticleSystemSPH system;
};

class EveryPrecision : public ::testing::TestWithParam<Precision> {};
INSTANTIATE_TEST_SUITE_P(SteadyStep, EveryPrecision, ::testing::Values(Precision::kFloat, Precision::kDouble));

TEST_P(EveryPrecision, AllocatesNothing) {
  Splash splash(GetParam(), 1);
  for (int step = 0; step < 300; ++step) splash.system.Step();
  ASSERT_FALSE(splash.system.Trouble()) << splash.system.Trouble()->Message();
  const long before = allocations;
  const long lists_before = splash.system.Neighbours().ListsMade();
  const long sorts_before = splash.system.Neighbours().Sorts();
  long steps_that_allocate = 0;
  for (int step = 0; step < 200; ++step) {
    const long then = allocations;
    splash.system.Step();
    steps_that_allocate += allocations > then ? 1 : 0;
  }
  EXPECT_GT(splash.system.Neighbours().ListsMade(), lists_before) << "else the test says little";
  EXPECT_GT(splash.system.Neighbours().Sorts(), sorts_before);
  // Lists of a flow that moves grow now and then.
  EXPECT_LE(steps_that_allocate, 10) << allocations - before << " allocations";
}

TEST_P(EveryPrecision, GivesTheSameBitsForAnyNumberOfThreads) {
  Splash alone(GetParam(), 1);
  for (int step = 0; step < 60; ++step) alone.system.Step();
  for (const int threads : {2, 3, 8}) {
    Splash together(GetParam(), threads);
    for (int step = 0; step < 60; ++step) together.system.Step();
    ASSERT_FALSE(together.system.Trouble());
    EXPECT_EQ(together.system.State().x, alone.system.State().x) << threads;
    EXPECT_EQ(together.system.State().vy_prev, alone.system.State().vy_prev) << threads;
    EXPECT_EQ(together.system.State().id, alone.system.State().id) << threads;
  }
}

}  // namespace
}  // namespace sph
