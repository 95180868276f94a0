// The fast system and the paper's own loops agree on a fluid in motion.
#include "sph/paper_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sph/given_system.hpp"

namespace sph {
namespace {

TEST(PaperLoops, AgreeWithTheSystemOnDensityAndAcceleration) {
  Parameters base = NoForces();
  base.fluid = {900, {{0, 0, 0.9, 0.9}, {}, 0}, Arrangement::kJittered, 0.03, 0.01, {}};
  base.particle_mass = 0.03 * 0.03;
  ParametersSPH sph;
  sph.smoothing_length = 1.3 * 0.03;
  sph.equation_of_state = Tait{3, 1, 7};
  ParticleSystemSPH system(base, sph);
  system.Reset();
  const Particles& p = system.State();
  PaperLoops loops(p.x, p.y, base.particle_mass, sph.smoothing_length, 3, 1);
  loops.ComputePressures();
  loops.AddSpatialInteraction();
  const std::vector<double> density = system.Density();
  double greatest = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) greatest = std::max(greatest, std::hypot(p.ax[i], p.ay[i]));
  for (std::size_t i = 0; i < p.Size(); ++i) {
    // Its positions are floats of 1 m: 6e-8 m of a smoothing length of 0.039 m.
    EXPECT_NEAR(loops.Density(i), density[i], 1e-5 * density[i]);
    EXPECT_NEAR(loops.Ax(i), p.ax[i], 1e-4 * greatest);
    EXPECT_NEAR(loops.Ay(i), p.ay[i], 1e-4 * greatest);
  }
}

}  // namespace
}  // namespace sph
