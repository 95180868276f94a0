// Periodic boundaries against a plane tiled with copies of the particles.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_twins.hpp"

namespace sph {
namespace {

const Box kTile{-1, 2, 0, 2.7};  // [m]

Cloud InTheTile(std::size_t n) {
  Random random(5);
  Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    cloud.x.push_back(random.Uniform(kTile.x0, kTile.x1));
    cloud.y.push_back(random.Uniform(kTile.y0, kTile.y1));
    cloud.vx.push_back(random.Uniform(-1, 1));
    cloud.vy.push_back(random.Uniform(-1, 1));
    cloud.mass.push_back(random.Uniform(0.5, 1.5) / static_cast<double>(n));
  }
  return cloud;
}

/// The cloud, and after it its copies in the tiles around.
Cloud Tiled(const Cloud& cloud, const Periods& periods) {
  Cloud tiled = cloud;
  for (int a = -1; a <= 1; ++a) {
    for (int b = -1; b <= 1; ++b) {
      if ((a == 0 && b == 0) || (a != 0 && !periods.in_x) || (b != 0 && !periods.in_y)) continue;
      for (std::size_t i = 0; i < cloud.Size(); ++i) {
        tiled.x.push_back(cloud.x[i] + a * periods.box.Width());
        tiled.y.push_back(cloud.y[i] + b * periods.box.Height());
        tiled.vx.push_back(cloud.vx[i]);
        tiled.vy.push_back(cloud.vy[i]);
        tiled.mass.push_back(cloud.mass[i]);
      }
    }
  }
  return tiled;
}

struct Case {
  const char* name;
  bool in_x, in_y;
  Precision precision;
};

class PeriodicBoundaries : public ::testing::TestWithParam<Case> {
 protected:
  static ParametersSPH Gas() {
    ParametersSPH gas{kCloudH, Polytrope{0.5}};
    gas.precision = GetParam().precision;
    gas.periods = {kTile, GetParam().in_x, GetParam().in_y};
    return gas;
  }
  static double Tolerance() {
    return GetParam().precision == Precision::kFloat ? kTolerance<float> : kTolerance<double>;
  }
};
INSTANTIATE_TEST_SUITE_P(Tiles, PeriodicBoundaries,
                         ::testing::Values(Case{"x", true, false, Precision::kDouble},
                                           Case{"y", false, true, Precision::kDouble},
                                           Case{"both", true, true, Precision::kDouble},
                                           Case{"bothInFloat", true, true, Precision::kFloat}),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(PeriodicBoundaries, GiveTheDensityAndAccelerationsOfATiledPlane) {
  Parameters base = NoForces();
  base.fluid.particles = 500;
  base.time_step = 1e-3;
  GivenSystem system(base, Gas(), InTheTile(500));
  for (int step = 0; step < 30; ++step) {
    system.Step();  // some leave the tile, and come back on the other side
    ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
  }
  system.ComputeFields();
  const Cloud tiled = Tiled(CloudOf(system), Gas().periods);
  const auto density = PlainDensity(tiled, kCloudH);
  const auto found = system.Density();
  double greatest = 0, greatest_push = 0;
  std::vector<double> exact_density;
  for (const PlainSum& sum : density) {
    exact_density.push_back(sum.value.x);
    greatest = std::max(greatest, sum.value.x);
  }
  std::vector<double> pressure;
  for (const double rho : exact_density) pressure.push_back(0.5 * rho * rho);
  // The copies at the rim of the tiled plane lack neighbours, but no particle of the tile sees them.
  for (std::size_t i = 0; i < 500; ++i) ASSERT_NEAR(found[i], exact_density[i], Tolerance() * greatest) << i;
  for (std::size_t i = 500; i < tiled.Size(); ++i)
    pressure[i] = pressure[i % 500], exact_density[i] = exact_density[i % 500];
  const auto push = PlainPressureAcceleration(tiled, exact_density, pressure, kCloudH);
  for (std::size_t i = 0; i < 500; ++i) greatest_push = std::max(greatest_push, Length(push[i].value));
  for (std::size_t i = 0; i < 500; ++i) {
    const Vec2 a{system.State().ax[i], system.State().ay[i]};
    ASSERT_LT(Length(a - push[i].value), 4 * Tolerance() * greatest_push) << i;
  }
}

TEST_P(PeriodicBoundaries, HaveTheNeighboursOfATiledPlane) {
  Parameters base = NoForces();
  base.fluid.particles = 500;
  const GivenSystem system(base, Gas(), InTheTile(500));
  const Cloud tiled = Tiled(CloudOf(system), Gas().periods);
  int pairs = 0;
  for (std::size_t i = 0; i < 500; ++i) {
    for (std::size_t j = 0; j < tiled.Size(); ++j) {
      const double apart = std::hypot(tiled.x[i] - tiled.x[j], tiled.y[i] - tiled.y[j]);
      pairs += j != i && apart < 2 * kCloudH ? 1 : 0;
    }
  }
  EXPECT_NEAR(system.MeanNeighbours(), pairs / 500.0, 0.005) << "but for one pair just within or out of reach";
}

TEST_P(PeriodicBoundaries, KeepMomentum) {
  Parameters base = NoForces();
  base.fluid.particles = 500;
  base.time_step = 1e-3;
  GivenSystem system(base, Gas(), InTheTile(500));
  const auto momentum = [&] {
    Vec2 sum;
    const Particles& p = system.State();
    for (std::size_t i = 0; i < p.Size(); ++i) sum = sum + p.mass[i] * Vec2{p.vx_prev[i], p.vy_prev[i]};
    return sum;
  };
  const Vec2 before = momentum();
  for (int step = 0; step < 100; ++step) system.Step();
  const Vec2 lost = momentum() - before;
  EXPECT_LT(Length(lost), GetParam().precision == Precision::kFloat ? 1e-6 : 1e-13);
}

}  // namespace
}  // namespace sph
