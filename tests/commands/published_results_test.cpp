// The results that the two documents promise, reached by the scenes as they are: minutes, so all of it is Slow.
//
// SPHLAB_SEEDS=100 has the breaking dam tried with 100 random starts instead of 20.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "commands/report.hpp"
#include "particles/diagnostics.hpp"
#include "window/key_script.hpp"
#include "window/session.hpp"

namespace sph {
namespace {

Session MakeSession(const std::string& scene, std::size_t particles, std::uint64_t seed, int threads) {
  SceneRequest request;
  request.scene = scene;
  request.particles = particles;
  request.seed = seed;
  request.threads = threads;
  return Session(request);
}

/// Steps to `until` [s] as `sphlab run` does, and calls look(session) before each step.
template <typename Look>
void Play(Session& session, KeyScript& keys, double until, Look look) {
  while (session.System().Time() < until - 1e-6 && !session.System().Trouble()) {
    keys.Play(session);
    look(session);
    session.Step();
  }
  session.System().ComputeFields();
}

void ExpectTheExactStar(std::size_t particles) {
  Session star = MakeSession("toy-star", particles, 1, 0);
  KeyScript no_keys;
  Play(star, no_keys, 20, [](Session&) {});
  ASSERT_FALSE(star.System().Trouble()) << star.System().Trouble()->Message();
  // The paper reports 0.04 for 3000 particles. What is left is at the star's edge, where eq. 8 smooths the density.
  EXPECT_LE(ErrorsAgainstReference(star).at("density_mse"), 2.5e-3);
  const Diagnostics d = Diagnose(star.System());
  EXPECT_LT(d.kinetic_energy, 1e-4);
  EXPECT_NEAR(Length(d.centre_of_mass), 0, 0.01) << "the start's mean is random, and damped";
  EXPECT_EQ(d.outside, 0u);
}

TEST(ToyStar, SlowOfTableOneComesToItsExactDensity) { ExpectTheExactStar(1000); }
TEST(ToyStar, SlowOfThreeThousandParticlesComesToItsExactDensity) { ExpectTheExactStar(3000); }

/// Table II's dam: it settles by t = 4, breaks then, and reaches the far wall; no particle is ever far inside a wall.
void ExpectTheDamToBreak(std::size_t particles, std::uint64_t seed, int threads) {
  SCOPED_TRACE(fmt::format("{} particles, seed {}", particles, seed));
  Session dam = MakeSession("dam-break", particles, seed, threads);
  KeyScript keys("4:d", dam.CurrentScene());
  const double spacing = dam.System().InitialSpacing();
  Play(dam, keys, 4, [](Session&) {});
  const Diagnostics settled = Diagnose(dam.System());
  EXPECT_LT(settled.kinetic_energy, 1e-3);
  EXPECT_LT(settled.bounds.x1, -0.35 + 0.5 * spacing) << "behind the dam";
  double furthest = settled.bounds.x1;
  Play(dam, keys, 6, [&](Session& session) {
    const Particles& p = session.System().State();
    furthest = std::max(furthest, *std::max_element(p.x.begin(), p.x.end()));
  });
  EXPECT_FALSE(dam.System().Trouble()) << dam.System().Trouble()->Message();
  EXPECT_GT(furthest, 0.95 - spacing) << "at the far wall";
  const Diagnostics end = Diagnose(dam.System());
  EXPECT_EQ(end.outside, 0u);
  EXPECT_LE(end.deepest, 0.5) << "at any time, so nobody was outside at any time";
}

TEST(DamBreak, SlowSettlesBreaksAndStaysInsideForManySeeds) {
  const char* wanted = std::getenv("SPHLAB_SEEDS");
  const int seeds = wanted != nullptr ? std::atoi(wanted) : 20;
  const auto every_second = [&](int first) {
    for (int seed = first; seed <= seeds; seed += 2) ExpectTheDamToBreak(600, static_cast<std::uint64_t>(seed), 1);
  };
  std::thread other(every_second, 2);
  every_second(1);
  other.join();
}

TEST(DamBreak, SlowOfFourTimesTheParticlesStaysInsideToo) { ExpectTheDamToBreak(2400, 1, 0); }

TEST(DamBreak, SlowOfSixteenTimesTheParticlesIsHeldByItsWallsDuringTheCollapse) {
  Session dam = MakeSession("dam-break", 9600, 1, 0);
  KeyScript no_keys;
  Play(dam, no_keys, 0.5, [](Session&) {});  // the walls are hit hardest in the first half second
  ASSERT_FALSE(dam.System().Trouble()) << dam.System().Trouble()->Message();
  const Diagnostics d = Diagnose(dam.System());
  EXPECT_EQ(d.outside, 0u);
  EXPECT_LE(d.deepest, 0.5);
}

TEST(DamBreak, SlowWithPublishedWallsLeaksWhereTheDerivedOnesHold) {
  // Four times the particles at constant stiffness go four times as deep in spacings (IV-D leaves open why).
  Session derived = MakeSession("dam-break", 2400, 1, 0);
  SceneRequest request;
  request.particles = 2400;
  request.settings = {"walls.scaling=published"};
  Session published(request);
  KeyScript no_keys;
  Play(derived, no_keys, 0.5, [](Session&) {});
  Play(published, no_keys, 0.5, [](Session&) {});
  EXPECT_GT(Diagnose(published.System()).deepest, 2 * Diagnose(derived.System()).deepest);
}

TEST(Mueller, SlowKeepsItsEnergyBoundedWithEightBlocksDropped) {
  Session tank = MakeSession("mueller", 500, 1, 0);
  KeyScript keys("0.5:space,1.5:space,2.5:space,3.5:space,4.5:space,5.5:space,6.5:space,7.5:space",
                 tank.CurrentScene());
  const auto energy = [](const ParticleSystemSPH& system) {
    const Diagnostics d = Diagnose(system);
    return d.kinetic_energy + d.potential_energy + d.internal_energy;
  };
  double bound = 0;  // [J/m]: the energy when the last block came in; only viscosity and walls act afterwards
  std::size_t particles = 0;
  double worst = 0;  // energy over that bound
  Play(tank, keys, 10, [&](Session& session) {
    const ParticleSystemSPH& system = session.System();
    if (system.Steps() % 20 != 0 && system.State().Size() == particles) return;
    if (system.State().Size() != particles) {
      particles = system.State().Size();
      session.System().ComputeFields();
      bound = energy(system);
    }
    worst = std::max(worst, energy(system) / bound);
  });
  ASSERT_FALSE(tank.System().Trouble()) << tank.System().Trouble()->Message();
  EXPECT_EQ(tank.System().State().Size(), 2500u);
  EXPECT_LE(worst, 1.01) << "a hundredth for what the time step adds in a splash";
  const double fall = std::sqrt(2 * 10 * 8.84);  // [m/s], from the ceiling to the floor
  EXPECT_LT(Diagnose(tank.System()).max_speed, fall);
  EXPECT_EQ(tank.System().DropBlock().find("particle limit of 2500 reached"), 0u);
}

}  // namespace
}  // namespace sph
