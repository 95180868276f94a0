// Starts that take a run of their own.
#include "scenes/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

Scene Loaded(const std::string& name, std::size_t particles, std::vector<std::string> settings) {
  SceneRequest request;
  request.scene = name;
  request.particles = particles;
  request.settings = std::move(settings);
  return LoadScene(request);
}

/// From a particle to its nearest neighbour [m].
struct Distances {
  double least = std::numeric_limits<double>::max(), mean = 0;
};
Distances ToNearest(const Particles& p) {
  Distances distances;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < p.Size(); ++j) {
      if (j != i) nearest = std::min(nearest, Length(p.Position(i) - p.Position(j)));
    }
    distances.least = std::min(distances.least, nearest);
    distances.mean += nearest / static_cast<double>(p.Size());
  }
  return distances;
}

TEST(Relaxed, ParticlesAreFarApartAlthoughTheyAreRandom) {
  const auto system = MakeSystem(Loaded("still-water", 800, {"fluid.arrange=relaxed"}));
  const Particles& p = system->State();
  ASSERT_EQ(p.Size(), 800u);
  const double spacing = std::sqrt(1.8 / 800);
  const Distances relaxed = ToNearest(p);
  EXPECT_GT(relaxed.least, 0.75 * spacing);  // at random the mean is 0.5, the least about 0.02
  EXPECT_GT(relaxed.mean, 0.95 * spacing);   // of hexagons 1.07
  for (std::size_t i = 0; i < p.Size(); ++i) {
    EXPECT_TRUE(p.x[i] > 0.2 * spacing && p.x[i] < 2 - 0.2 * spacing && p.y[i] > 0.2 * spacing &&
                p.y[i] < 0.9 - 0.2 * spacing)
        << "the sides repel, " << i;
  }
  const auto other = MakeSystem(Loaded("still-water", 800, {"fluid.arrange=relaxed", "seed=2"}));
  EXPECT_NE(other->State().x, p.x);
  const auto same = MakeSystem(Loaded("still-water", 800, {"fluid.arrange=relaxed", "fluid.spacing=1e-200"}));
  const auto in_order = [](const ParticleSystem& of) {
    std::vector<double> x = of.State().x;
    std::ranges::sort(x);
    return x;
  };
  EXPECT_EQ(in_order(*same), in_order(*system)) << "a spacing is a lattice's";
}

TEST(Relaxed, DiskHasAllItsParticlesAndAPeriodicBoxNoSeam) {
  const auto disk = MakeSystem(Loaded("elliptic-drop", 700, {"fluid.arrange=relaxed"}));
  ASSERT_EQ(disk->State().Size(), 700u);
  double furthest = 0;
  for (std::size_t i = 0; i < 700; ++i) furthest = std::max(furthest, Length(disk->State().Position(i)));
  EXPECT_NEAR(furthest, 1, 0.03) << "radius 1 m, spacing 0.067 m";
  const auto box = MakeSystem(Loaded("taylor-green", 400, {"fluid.arrange=relaxed"}));
  Particles shifted = box->State();
  for (double& x : shifted.x) x = std::fmod(x + 0.5, 1.0);
  EXPECT_GT(ToNearest(shifted).least, 0.75 * 0.05) << "what was the seam is in the middle";
}

TEST(Relaxed, RefusesARegionWithoutRoom) {
  EXPECT_THROW(Loaded("elliptic-drop", 700, {"fluid.arrange=relaxed", "fluid.region.disk.radius=1e-161"}), UsageError);
}

TEST(Settling, LeavesAStarAtRestThatWouldOtherwiseBreathe) {
  const auto swing = [](std::vector<std::string> settings) {
    settings.push_back("fluid.flow=star");
    const auto system = MakeSystem(Loaded("breathing-star", 3000, settings));
    double fastest = 0;
    for (int k = 0; k < 100; ++k) {
      system->Step();
      fastest = std::max(fastest, Diagnose(*system).max_speed);
    }
    return fastest;
  };
  const double at_once = swing({"fluid.settle={time=1e-9,damping=1}"});
  EXPECT_GT(at_once, 1e-3);
  EXPECT_LT(swing({"fluid.settle={time=20,damping=4}"}), 0.06 * at_once);
}

TEST(Settling, GivesMassesAndFlowAsWithoutIt) {
  const Scene scene = Loaded("breathing-star", 500, {});
  ASSERT_GT(scene.settling.time, 0);
  const auto settled = MakeSystem(scene);
  const auto placed = MakeSystem(Loaded("breathing-star", 500, {"fluid.settle.time=1e-9"}));
  ASSERT_EQ(settled->State().Size(), placed->State().Size());
  EXPECT_NEAR(Diagnose(*settled).kinetic_energy, Diagnose(*placed).kinetic_energy,
              0.03 * Diagnose(*placed).kinetic_energy)
      << "so coarse a star is a hundredth smaller at rest than the exact one";
  double mass = 0, mass_as_placed = 0;
  for (const double m : settled->State().mass) mass += m;
  for (const double m : placed->State().mass) mass_as_placed += m;
  EXPECT_NEAR(mass, mass_as_placed, 1e-12 * mass);
  EXPECT_EQ(settled->Time(), 0);
  EXPECT_EQ(settled->parameters.motion_damping, placed->parameters.motion_damping);
}

TEST(Settling, ThatBreaksDownIsAnError) {
  try {
    MakeSystem(Loaded("dam-break", 600, {"fluid.settle={time=1,damping=0.001}", "method.time_step=0.2"}));
    FAIL() << "it settled";
  } catch (const TroubleError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot settle"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sph
