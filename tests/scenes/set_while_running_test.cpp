// Which keys a running scene may still change.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/scene_keys.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

std::string RefusalOf(const std::string& key, double value) {
  Scene scene = SceneFrom(kScene);
  try {
    SetWhileRunning(scene, key, value);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SetWhileRunning, TakesEveryKeyOfAnyTimeAndNoOther) {
  for (const SceneKey& key : AllSceneKeys()) {
    const double value = key.name.ends_with("exponent") ? 3 : 1;  // accepted by all: numbers, whole numbers, shares
    const std::string refusal = RefusalOf(key.name, value);
    if (key.when == When::kAnyTime) {
      EXPECT_EQ(refusal, "accepted") << key.name;
    } else {
      EXPECT_TRUE(Has(refusal, {"'" + key.name + "'", "cannot be set while the scene runs"}));
    }
  }
}

TEST(SetWhileRunning, ChangesTheScene) {
  Scene scene = SceneFrom(kScene);
  SetWhileRunning(scene, "forces.damping", 0.25);
  SetWhileRunning(scene, "fluid.limit", 77);
  SetWhileRunning(scene, "equation_of_state.tait.rho0", 2);
  EXPECT_EQ(scene.base.motion_damping, 0.25);
  EXPECT_EQ(scene.base.particle_limit, 77u);
  EXPECT_EQ(std::get<Tait>(scene.sph.equation_of_state).rho0, 2);
}

TEST(SetWhileRunning, ChecksValuesAsTheFileDoes) {
  EXPECT_TRUE(Has(RefusalOf("forces.damping", -1), {"forces.damping = -1", ">= 0"}));
  EXPECT_TRUE(Has(RefusalOf("method.time_step", 0), {"method.time_step = 0", "> 0"}));
  EXPECT_TRUE(Has(RefusalOf("method.time_step", NAN), {"finite"}));
  EXPECT_TRUE(Has(RefusalOf("method.time_step", INFINITY), {"finite"}));
  EXPECT_TRUE(Has(RefusalOf("fluid.limit", 1.5), {"a whole number"}));
  EXPECT_TRUE(Has(RefusalOf("fluid.limit", 1e300), {"a whole number"}));
}

TEST(SetWhileRunning, RefusesUnknownKeysWithTheNearestThatMayChange) {
  EXPECT_TRUE(Has(RefusalOf("forces.dampin", 1), {"is not a scene key", "Did you mean 'forces.damping'?"}));
}

}  // namespace
}  // namespace sph
