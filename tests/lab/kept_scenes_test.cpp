// Random scenes in which something was found, in the program or in what it is held to: each runs as `sphlab stress
// random` runs it.
#include <gtest/gtest.h>

#include "lab/random_course.hpp"

namespace sph {
namespace {

struct KeptScene {
  const char* what;  ///< for messages: what was, or might be, wrong
  RandomScene scene;
  std::uint64_t seed;
  long steps;
};

const std::vector<KeptScene>& KeptScenes() {
  static const std::vector<KeptScene> scenes = {
      {"a gravity whose squares are no numbers",
       {.text = R"(title = "random"
fluid.particles = 44
fluid.mass = 8.366635e-02
fluid.region.box = [0.0, 0.0, 8.769837e-01, 6.148541e-01]
equation_of_state.polytrope.k = 5.786455e+00
method.smoothing_length = 2.652104e-01
method.time_step = 2.977384e-02
solver = "mueller"
fluid.jitter = 1.164501e-01
drop.spacing = 2.081184e+05
method.integration = "leapfrog"
forces.gravity = [1.168472e-06, 7.688104e+118]
walls.kind = "penalty"
periodic = { box = [0.0, 0.0, 1.270978e+00, 1.535681e+00], directions = "y" }
wall = [ { name = "a", at = 2.029159e+00, fluid = "left" }, { name = "b", at = -2.820190e+00, fluid = "right" },
         { name = "c", at = 2.409116e+00, fluid = "below" } ]
)"},
       8606,
       1000},
      {"a drop stretched to a sheet as thin as its particles seemed to lose area",
       {.base = "elliptic-drop", .settings = {"method.shifting=on", "drop.particles=54"}},
       46,
       1000},
  };
  return scenes;
}

TEST(KeptScenes, AreFlawedNoMore) {
  for (const KeptScene& kept : KeptScenes()) {
    const Course course = CourseOf(kept.scene, kept.seed, kept.steps, 1);
    EXPECT_NE(course.ending, Ending::kFlawed) << kept.what << ": " << course.flaw;
    EXPECT_NE(course.ending, Ending::kRefused) << kept.what;
  }
}

}  // namespace
}  // namespace sph
