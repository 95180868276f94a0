// Gauges of how particles fill the plane: exact for lattices, and right about what is put in.
#include "lab/fill_gauges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

/// Rows and columns whose outermost are half a spacing off the sides of the box (0, 0, columns dx, rows dy).
Particles Lattice(int columns, int rows, double dx, double dy) {
  Particles particles;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) particles.Add({(column + 0.5) * dx, (row + 0.5) * dy}, {}, 1);
  }
  return particles;
}

RC_GTEST_PROP(FilledHeight, OfALatticeIsItsHeight, ()) {
  const int columns = *rc::gen::inRange(8, 60), rows = *rc::gen::inRange(8, 60);
  const double dx = 0.01 * *rc::gen::inRange(1, 50);
  const double height = FilledHeight(Lattice(columns, rows, dx, dx), {0, columns * dx, 0}, dx);
  RC_ASSERT(std::abs(height - rows * dx) < 1e-3 * dx);
}

TEST(FilledHeight, SinksWithTheParticlesWhateverTheirDensitySays) {
  const double height = FilledHeight(Lattice(50, 45, 0.02, 0.97 * 0.02), {0, 1, 0}, 0.02);
  EXPECT_NEAR(height, 0.97 * 0.9, 0.05 * 0.02) << "a sum that is 3 % greater reaches 1/2 so much higher";
}

TEST(FilledHeight, IsTheMeanOfATiltedSurface) {
  Particles particles;
  for (const auto all = Lattice(50, 70, 0.02, 0.02); const double slope : {0.5}) {
    for (std::size_t i = 0; i < all.Size(); ++i) {
      if (all.y[i] < 0.9 + slope * (all.x[i] - 0.5)) particles.Add(all.Position(i), {}, 1);
    }
  }
  EXPECT_NEAR(FilledHeight(particles, {0, 1, 0}, 0.02), 0.9, 0.1 * 0.02) << "the surface has steps of a spacing";
}

TEST(FilledHeight, ADropAboveTheSurfaceAndAVoidBelowDoNotCount) {
  Particles particles = Lattice(50, 45, 0.02, 0.02);
  particles.Add({0.5, 1.2}, {}, 1);
  EXPECT_NEAR(FilledHeight(particles, {0, 1, 0}, 0.02), 0.9, 1e-3 * 0.02);
  EXPECT_LT(FilledHeight(Lattice(40, 45, 0.02, 0.02), {0, 1, 0}, 0.02), 0.75) << "a fifth of the trough is dry";
}

TEST(MeanConcentration, IsThatOfALatticeAndGrowsWithMass) {
  SceneRequest request;
  request.scene = "still-water";
  request.settings = {"fluid.masses=equal"};
  const auto full_tank = [&] {
    Scene scene = LoadScene(request);
    Wall ceiling;
    ceiling.fluid = FluidSide::kBelow;
    ceiling.at = ceiling.lowest = ceiling.highest = scene.base.fluid.region.box.y1;
    scene.base.walls.push_back(ceiling);
    return MakeSystem(scene);
  };
  const double even = MeanConcentration(*full_tank());
  EXPECT_NEAR(even, 1, 0.01) << "the sum over a lattice is 0.6 % too great with 1.4 spacings to h";
  request.settings.emplace_back("fluid.mass=0.404");
  EXPECT_NEAR(MeanConcentration(*full_tank()) / even, 1.01, 1e-9);
}

TEST(PairedShare, CountsBothOfAPair) {
  Particles particles = Lattice(10, 10, 1, 1);
  EXPECT_EQ(PairedShare(particles, 0.999), 0);
  EXPECT_EQ(PairedShare(particles, 1.001), 1);
  particles.x[33] = particles.x[34] - 0.3;
  EXPECT_DOUBLE_EQ(PairedShare(particles, 0.5), 0.02);
}

}  // namespace
}  // namespace sph
