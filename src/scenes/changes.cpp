#include "scenes/changes.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scenes/build.hpp"
#include "scenes/scene_file.hpp"

namespace sph {

namespace {

/// Whether forces and energies of the state as it is are numbers, with the parameters that there are now.
bool HasNumbers(ParticleSystemSPH& system) {
  if (system.Trouble()) return true;
  system.ComputeFields();
  double sum = system.InternalEnergy();
  for (const auto* component : {&system.State().ax, &system.State().ay}) {
    for (const double a : *component) sum += a;
  }
  return std::isfinite(sum);
}

}  // namespace

void MoveWallTo(ParticleSystemSPH& system, const std::string& name, double to) {
  Wall* wall = FindWall(system.parameters.walls, name);
  SPH_CHECK(wall != nullptr, "wall '{}'", name);
  wall->at = to;
  wall->velocity = 0;
  wall->lowest = std::min(wall->lowest, to);
  wall->highest = std::max(wall->highest, to);
}

void SetWhileRunning(Scene& scene, ParticleSystemSPH& system, const std::string& key, double to) {
  Scene trial = scene;
  SetWhileRunning(trial, key, to);
  if (trial.sph.equation_of_state.index() != scene.sph.equation_of_state.index()) {
    throw UsageError("{}: '{}' would be another equation of state: it cannot change while the scene runs", scene.name,
                     key);
  }
  // Walls may have moved since the scene was read, and a guard may have shortened the step; everything else is as the
  // scene says.
  Parameters changed = CompleteParameters(trial);
  const Parameters before = system.parameters;
  const ParametersSPH before_sph = system.parameters_sph;
  changed.walls = before.walls;
  changed.caution = before.caution;
  if (key != "method.time_step") changed.time_step = before.time_step;
  system.parameters = changed;
  system.parameters_sph = trial.sph;
  if (!HasNumbers(system)) {
    system.parameters = before;
    system.parameters_sph = before_sph;
    throw UsageError("{}: with {} = {} forces or energies are not numbers", scene.name, key, to);
  }
  scene = std::move(trial);
}

void PressSceneKey(const std::string& key, Scene& scene, ParticleSystemSPH& system) {
  const auto control = std::ranges::find(scene.controls, key, &SceneControl::press);
  if (control == scene.controls.end()) return;
  const std::vector<std::variant<MoveWallAction, SetAction>> actions = control->actions;
  for (const auto& action : actions) {
    if (const auto* move = std::get_if<MoveWallAction>(&action)) {
      MoveWallTo(system, move->wall, move->to);
    } else {
      const auto& set = std::get<SetAction>(action);
      SetWhileRunning(scene, system, set.key, set.to);
    }
  }
}

}  // namespace sph
