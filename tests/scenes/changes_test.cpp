// What may be changed of a scene and its system while they run, and what is refused.
#include "scenes/changes.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

struct Running {
  explicit Running(const std::string& name = "dam-break") {
    SceneRequest request;
    request.scene = name;
    request.particles = 200;
    scene = LoadScene(request);
    system = MakeSystem(scene);
    for (int k = 0; k < 10; ++k) system->Step();
  }
  std::string Set(const std::string& key, double to) {
    try {
      SetWhileRunning(scene, *system, key, to);
    } catch (const UsageError& error) {
      return error.what();
    }
    return {};
  }

  Scene scene;
  std::unique_ptr<ParticleSystemSPH> system;
};

TEST(Changes, AKeyReachesSceneAndSystem) {
  Running running;
  EXPECT_EQ(running.Set("forces.damping", 0.25), "");
  EXPECT_EQ(running.scene.base.motion_damping, 0.25);
  EXPECT_EQ(running.system->parameters.motion_damping, 0.25);
}

TEST(Changes, WhatTheFluidDoesNotBearIsRefusedAndNothingChanges) {
  Running running;
  const auto before = std::get<Tait>(running.system->parameters_sph.equation_of_state);
  const std::string message = running.Set("equation_of_state.tait.rho0", 1e-300);
  EXPECT_NE(message.find("not numbers"), std::string::npos) << message;
  EXPECT_EQ(std::get<Tait>(running.system->parameters_sph.equation_of_state).rho0, before.rho0);
  EXPECT_EQ(std::get<Tait>(running.scene.sph.equation_of_state).rho0, before.rho0);
  running.system->Step();
  EXPECT_FALSE(running.system->Trouble());
}

TEST(Changes, AnotherEquationOfStateIsRefused) {
  Running running("water-column");
  EXPECT_NE(running.Set("equation_of_state.polytrope.k", 1).find("another equation of state"), std::string::npos);
  EXPECT_TRUE(std::holds_alternative<IdealGas>(running.scene.sph.equation_of_state));
}

TEST(Changes, ASceneKeyDoesWhatTheSceneSays) {
  Running running;
  PressSceneKey("d", running.scene, *running.system);
  EXPECT_EQ(FindWall(running.system->parameters.walls, "dam")->at, 0.95);
  EXPECT_EQ(running.system->parameters.motion_damping, 1);
  PressSceneKey("x", running.scene, *running.system);  // which means nothing there
  EXPECT_EQ(running.system->parameters.motion_damping, 1);
}

TEST(Changes, AWallMovedBeyondItsRangeStaysThere) {
  Running running;
  running.system->parameters.walls[1].velocity = 1;
  MoveWallTo(*running.system, "dam", 2);
  const Wall& dam = *FindWall(running.system->parameters.walls, "dam");
  EXPECT_EQ(dam.at, 2);
  EXPECT_EQ(dam.velocity, 0);
  EXPECT_EQ(dam.highest, 2);
}

}  // namespace
}  // namespace sph
