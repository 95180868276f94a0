// Whole runs of the paper's scenes against what is exact, derived or measured of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

std::unique_ptr<ParticleSystemSPH> Make(const std::string& scene, std::size_t particles, const std::string& setting) {
  SceneRequest request;
  request.scene = scene;
  request.particles = particles;
  request.settings = {setting};
  request.threads = 1;  // test programs run side by side
  return MakeSystem(LoadScene(request));
}

void RunUntil(ParticleSystemSPH& system, double time) {
  while (system.Time() < time && !system.Trouble()) system.Step();
  ASSERT_FALSE(system.Trouble()) << system.Trouble()->Message();
  system.ComputeFields();
}

TEST(ToyStarScene, SlowComesToRestAtTheExactDensity) {
  const auto star = Make("toy-star", 1000, "until=20");
  RunUntil(*star, 20);
  const Particles& p = star->State();
  const DensityErrors errors = CompareDensity({2.0, 0.75, 0.1}, p.x, p.y, star->Density());
  // 2.3e-3 is measured at N = 3000 by a plain program (SEEDS; the paper says 0.04), 2.0e-3 to 2.1e-3 here with four
  // seeds. The error comes from h over the spacing more than from N.
  EXPECT_LE(errors.mse, 2.5e-3);
  EXPECT_GT(errors.mse, 1e-4) << "better than equal masses with this h can be: is it the star that is compared?";
  EXPECT_LT(Diagnose(*star).kinetic_energy, 1e-4);
}

/// The settled column of Table II: by how much, in spacings, the particles in the floor are in it on average, and the
/// floor's force over the fluid's weight.
struct Settled {
  double depth_in_spacings = 0;
  double force_over_weight = 0;
};

Settled SettleDam(std::size_t particles, const std::string& scaling) {
  const auto dam = Make("dam-break", particles, "walls.scaling=" + scaling);
  RunUntil(*dam, 5);
  const Particles& p = dam->State();
  double force = 0, weight = 0, depths = 0, inside = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double depth = std::max(0.0, -0.95 - p.y[i]);
    force += p.mass[i] * dam->parameters.wall.stiffness * depth;
    weight += p.mass[i] * 9.8;
    depths += depth;
    inside += depth > 0 ? 1 : 0;
  }
  return {depths / inside / dam->InitialSpacing(), force / weight};
}

TEST(WallScaling, SlowPublishedConstantsLetTheFluidSinkInWithItsNumberDerivedOnesDoNot) {
  const Settled coarse = SettleDam(150, "published");
  const Settled published = SettleDam(600, "published");
  const Settled derived = SettleDam(600, "derived");
  const Settled derived_coarse = SettleDam(150, "derived");
  // The floor carries the weight, but for what the damping of 8/s carries of the column's last creep: 1 to 2 % after 5
  // s.
  for (const Settled& s : {coarse, published, derived, derived_coarse}) EXPECT_NEAR(s.force_over_weight, 1, 0.03);
  // depth/dx = g H/(K dx^2) at four times N: four times as deep at the same K, as deep as before at four times K. (The
  // layer in the floor has four to five particles a spacing, as this fluid is compressible, and not the derivation's
  // one; it has them for either N, within 10 %: measured are ratios of 4.3 and 1.1.)
  EXPECT_NEAR(published.depth_in_spacings / coarse.depth_in_spacings, 4, 1);
  EXPECT_NEAR(derived.depth_in_spacings / derived_coarse.depth_in_spacings, 1, 0.25);
}

TEST(DamBreakScene, SlowSettlesAsDenselyAsMeasured) {
  const auto dam = Make("dam-break", 600, "until=10");
  RunUntil(*dam, 5);
  // "the column settles with rho up to 5.0 at the floor" (SEEDS), by another program; four seeds give 4.98 to 5.03
  // here.
  EXPECT_NEAR(Diagnose(*dam).density.max, 5.0, 0.1);
  EXPECT_EQ(Diagnose(*dam).outside, 0u);
}

}  // namespace
}  // namespace sph
