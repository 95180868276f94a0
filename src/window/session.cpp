#include "window/session.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/scene_file.hpp"

namespace sph {

Session::Session(SceneRequest request) : request_(std::move(request)) { Load(request_); }

void Session::Load(const SceneRequest& request) {
  Scene loaded = LoadScene(request);
  system_ = MakeSystem(loaded);
  start_ = scene_ = std::move(loaded);
}

bool Session::StepUnlessPaused() {
  if (paused && single_steps == 0) return false;
  if (paused) --single_steps;
  system_->Step();
  return true;
}

void Session::Reset() {
  scene_ = start_;
  system_->Reset();
  paused = false;
  message = "reset";
}

void Session::DropBlock() {
  message = system_->DropBlock();
  if (message.empty()) message = fmt::format("{} particles dropped", system_->parameters.drop.particles);
}

void Session::PressSceneKey(const std::string& key) {
  const auto& controls = scene_.controls;
  const auto control =
      std::find_if(controls.begin(), controls.end(), [&](const SceneControl& c) { return c.press == key; });
  if (control == controls.end()) {
    message = fmt::format("{} does nothing in the scene {}", key, scene_.name);
    return;
  }
  for (const auto& action : control->actions) {
    if (const auto* move = std::get_if<MoveWallAction>(&action)) {
      Wall* wall = FindWall(system_->parameters.walls, move->wall);
      wall->at = move->to;
      wall->velocity = 0;
      wall->lowest = std::min(wall->lowest, wall->at);
      wall->highest = std::max(wall->highest, wall->at);
    } else {
      const auto& set = std::get<SetAction>(action);
      SetWhileRunning(scene_, set.key, set.to);
      // Walls may have moved since the scene was read; everything else is as the scene says.
      Parameters changed = CompleteParameters(scene_);
      changed.walls = system_->parameters.walls;
      system_->parameters = changed;
      system_->parameters_sph = scene_.sph;
    }
  }
  message = control->what;
}

void Session::MoveWall(int direction) {
  Wall* wall = FindWall(system_->parameters.walls, scene_.arrow_wall);
  if (wall == nullptr) {
    message = fmt::format("the scene {} has no wall to move", scene_.name);
    return;
  }
  wall->velocity = direction * scene_.arrow_speed;
}

void Session::GoToNextScene(int offset) {
  const auto names = SceneNames();
  const auto here = std::find(names.begin(), names.end(), scene_.name);
  const auto count = static_cast<int>(names.size());
  const int position = here == names.end() ? 0 : static_cast<int>(here - names.begin()) + offset;
  GoToScene((position + count) % count + 1);
}

void Session::GoToScene(int number) {
  const auto names = SceneNames();
  if (number < 1 || number > static_cast<int>(names.size())) {
    message = fmt::format("there are {} scenes", names.size());
    return;
  }
  try {
    // --set, --solver and --particles were meant for the first scene; seed and threads go along.
    SceneRequest next;
    next.scene = names[static_cast<std::size_t>(number - 1)];
    next.seed = request_.seed;
    next.threads = request_.threads;
    Load(next);
    request_ = next;
    message = scene_.title;
  } catch (const Error& error) {
    message = error.what();  // the scene that runs goes on
  }
}

void Session::NextColouring() {
  constexpr int kColourings = 4;
  colouring = static_cast<Colouring>((static_cast<int>(colouring) + 1) % kColourings);
  message = "colouring: " + NameOf(colouring);
}

void Session::ChangeSpeed(double factor) {
  speed = std::clamp(speed * factor, 1.0 / 64, 64.0);
  message = fmt::format("speed: {:g} simulated seconds per second", speed);
}

std::string NameOf(Colouring colouring) {
  switch (colouring) {
    case Colouring::kBlackDisks:
      return "black disks";
    case Colouring::kSpeed:
      return "speed";
    case Colouring::kPressure:
      return "pressure";
    case Colouring::kDensity:
      return "density";
  }
  return {};
}

}  // namespace sph
