// The velocity between particles: exact where it is linear, whatever is missing around.
#include "lab/velocity_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"

namespace sph {
namespace {

Particles Disordered(Vec2 (*velocity)(Vec2)) {
  Random random(7);
  Particles particles;
  for (int k = 0; k < 400; ++k) {
    const Vec2 at{random.Uniform(0, 1), random.Uniform(0, 1)};
    particles.Add(at, velocity(at), 1);
  }
  return particles;
}

TEST(VelocityAt, IsExactWhereTheVelocityIsLinear) {
  const auto linear = [](Vec2 at) { return Vec2{1 + 2 * at.x - 3 * at.y, 4 * at.x + at.y}; };
  const Particles particles = Disordered(linear);
  for (const Vec2 at : {Vec2{0.5, 0.5}, Vec2{0.5, 0}, Vec2{1, 0.3}, Vec2{0, 0}}) {
    EXPECT_LT(Length(VelocityAt(particles, at, 0.2) - linear(at)), 1e-12) << at.x << ", " << at.y;
  }
}

TEST(VelocityAt, ErrsWithTheSquareOfItsReachElsewhere) {
  const auto curved = [](Vec2 at) { return Vec2{at.y * at.y, 0}; };
  const double error = Length(VelocityAt(Disordered(curved), {0.5, 0.5}, 0.2) - Vec2{0.25, 0});
  EXPECT_LT(error, 0.2 * 0.2);
  EXPECT_GT(error, 1e-4);
}

TEST(VelocityAt, IsNoNumberWhereThereAreTooFew) {
  Particles particles;
  particles.Add({0, 0}, {1, 0}, 1);
  particles.Add({0.1, 0}, {1, 0}, 1);
  EXPECT_FALSE(std::isfinite(VelocityAt(particles, {0.05, 0.05}, 0.2).x));
  EXPECT_FALSE(std::isfinite(VelocityAt(particles, {5, 5}, 0.2).x));
}

}  // namespace
}  // namespace sph
