#include "window/session.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/changes.hpp"

namespace sph {
namespace {

/// Of the scene's file.
std::uint64_t FingerprintOf(const std::string& scene) {
  std::ifstream stream(FindScene(scene), std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  Hash hash;
  hash.Add(std::as_bytes(std::span(text)));
  return hash.Value();
}

}  // namespace

Session::Session(SceneRequest request) : request_(std::move(request)) { Load(request_); }

void Session::Load(const SceneRequest& request) {
  Scene loaded = LoadScene(request);
  system_ = MakeSystem(loaded);
  start_ = scene_ = std::move(loaded);
  set_keys_.clear();
  set_to_.clear();
  fingerprint_ = FingerprintOf(request.scene);
  guard_.emplace(*system_, scene_.retries);
  energy_ = {};
}

void Session::Mark() {
  guard_->Mark();
  energy_.Forget();
}

void Session::Step() {
  if (const std::string warning = energy_.Look(*system_); !warning.empty()) message = warning;
  const int retreats = guard_->Retreats();
  guard_->Step();
  if (guard_->Retreats() == retreats) return;
  message = guard_->LastRetreat();
  energy_.Forget();
}

bool Session::StepUnlessPaused() {
  if (paused && single_steps == 0) return false;
  if (paused) --single_steps;
  Step();
  return true;
}

void Session::Reset() {
  scene_ = start_;
  set_keys_.clear();
  set_to_.clear();
  system_->Reset();
  guard_->Reset();
  energy_ = {};
  paused = false;
  message = "reset";
}

void Session::GoBack() {
  guard_->GoBack();
  energy_.Forget();
  paused = true;
  message = fmt::format("back to t = {:.6g} s; p goes on", system_->Time());
}

void Session::DropBlock() {
  message = system_->DropBlock();
  if (!message.empty()) return;
  Mark();
  message = fmt::format("{} particles dropped", system_->parameters.drop.particles);
}

void Session::PressSceneKey(const std::string& key) {
  const auto& controls = scene_.controls;
  const auto found =
      std::find_if(controls.begin(), controls.end(), [&](const SceneControl& c) { return c.press == key; });
  if (found == controls.end()) {
    message = fmt::format("{} does nothing in the scene {}", key, scene_.name);
    return;
  }
  message = found->what;
  const std::vector actions(found->actions.begin(), found->actions.end());  // setting a key replaces the scene
  for (const auto& action : actions) {
    if (const auto* move = std::get_if<MoveWallAction>(&action)) {
      MoveWallTo(*system_, move->wall, move->to);
      continue;
    }
    const auto& set = std::get<SetAction>(action);
    try {
      SetKey(set.key, set.to);
    } catch (const UsageError& error) {
      message = error.what();  // the fluid as it is now does not bear it
    }
  }
  Mark();
}

void Session::SetKey(const std::string& key, double to) {
  SetWhileRunning(scene_, *system_, key, to);
  set_keys_.push_back(key);
  set_to_.push_back(to);
}

void Session::MoveWall(int direction) {
  Wall* wall = FindWall(system_->parameters.walls, scene_.arrow_wall);
  if (wall == nullptr) {
    message = fmt::format("the scene {} has no wall to move", scene_.name);
    return;
  }
  wall->velocity = direction * scene_.arrow_speed;
  Mark();
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

void Session::Transfer(Archive& archive) {
  SceneRequest now = request_;
  TransferRequest(archive, now);
  std::uint64_t fingerprint = fingerprint_;
  std::vector<std::string> keys = set_keys_;
  std::vector<double> values = set_to_;
  archive(fingerprint, keys, values);
  if (archive.Reading()) {
    if (FingerprintOf(now.scene) != fingerprint) {
      throw TroubleError("the file of the scene '{}' is not the one that the state was saved with", now.scene);
    }
    Archive::Require(keys.size() == values.size());
    now.threads = request_.threads;
    if (now.scene != request_.scene) Load(now);  // a key had led to another scene
    request_ = now;
    for (std::size_t k = 0; k < keys.size(); ++k) SetKey(keys[k], values[k]);
  }
  archive(paused, single_steps, speed, colouring);
  system_->Transfer(archive);
  guard_->Transfer(archive);
  if (archive.Reading()) energy_ = {};
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
