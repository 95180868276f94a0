#include "lab/random_course.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "lab/run_watch.hpp"
#include "lab/stress.hpp"
#include "particles/guard.hpp"
#include "scenes/build.hpp"
#include "scenes/changes.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

Scene Load(const RandomScene& random, std::uint64_t seed, int threads) {
  constexpr std::size_t kMost = 250;
  Scene scene;
  if (random.base.empty()) {
    scene = ParseScene(random.text, "random.toml", random.settings);
  } else {
    SceneRequest request;
    request.scene = random.base;
    request.settings = random.settings;
    scene = LoadScene(request);
    // As many as a scene has take too long ten thousand times.
    request.particles = kMost;
    if (scene.base.fluid.particles > kMost) scene = LoadScene(request);
  }
  constexpr double kMostSettling = 20;  // steps
  scene.settling.time = std::min(scene.settling.time, kMostSettling * scene.base.time_step);
  scene.base.threads = threads;
  scene.base.seed = seed;
  return scene;
}

/// A system, who steps it, and who watches; and the person before it.
class RandomRun {
 public:
  RandomRun(Scene& scene, ParticleSystemSPH& system, std::uint64_t seed)
      : scene_(scene), system_(system), guard_(system, scene.retries), watch_(scene, system), random_(seed) {}

  std::string Run(long steps) {
    constexpr long kHeld = 100;  // steps, of an arrow key
    expected_ = system_.State().Size();
    watch_.Look();
    for (long k = 1; k <= steps && !system_.Trouble(); ++k) {
      Step();
      if (k % RunWatch::kStepsApart == 0) watch_.Look();
      if (k == steps / 2) Disturb();
      if (k == steps / 2 + kHeld) LetGo();
    }
    guard_.ComputeFields();
    if (system_.State().Size() != expected_) {
      return fmt::format("{} particles of {}", system_.State().Size(), expected_);
    }
    if (system_.Trouble() && system_.Trouble()->limit.empty()) return "unstable without a cause";
    const std::string flaw = FirstFlaw(system_);
    return flaw.empty() ? watch_.Flaw() : flaw;
  }

 private:
  void Step() {
    const int retreats = guard_.Retreats();
    guard_.Step();
    if (guard_.Retreats() != retreats) watch_.BrokeDown(guard_.LastRetreat());
    if (system_.Trouble()) watch_.BrokeDown(system_.Trouble()->Message());
  }

  /// What a person may do meanwhile.
  void Disturb() {
    constexpr std::size_t kMost = 500;  // of a block that is dropped ten thousand times
    const double choice = random_.Uniform();
    if (choice < 0.3 || system_.Trouble()) return;
    const std::size_t block = system_.parameters.drop.particles;
    if (choice < 0.5) {
      PressKey();
    } else if (choice < 0.7 && block < kMost && system_.DropBlock().empty()) {
      expected_ += block;
      Mark();
    } else if (Wall* wall = FindWall(system_.parameters.walls, scene_.arrow_wall); choice >= 0.7 && wall != nullptr) {
      wall->velocity = choice < 0.85 ? -scene_.arrow_speed : scene_.arrow_speed;
      Mark();
    }
  }

  void PressKey() {
    if (std::ranges::find(scene_.controls, "d", &SceneControl::press) == scene_.controls.end()) return;
    try {
      PressSceneKey("d", scene_, system_);
    } catch (const UsageError&) {
      // the fluid does not bear it
    }
    Mark();
  }

  void LetGo() {
    Wall* wall = FindWall(system_.parameters.walls, scene_.arrow_wall);
    if (wall == nullptr || wall->velocity == 0) return;
    wall->velocity = 0;
    Mark();
  }

  void Mark() {
    guard_.Mark();
    watch_.Disturbed();
  }

  Scene& scene_;
  ParticleSystemSPH& system_;
  Guard guard_;
  RunWatch watch_;
  Random random_;
  std::size_t expected_ = 0;  // particles
};

}  // namespace

Course CourseOf(const RandomScene& random, std::uint64_t seed, long steps, int threads) {
  const Stopwatch watch;
  Course course;
  try {
    course.scene = Load(random, seed, threads);
    Scene running = course.scene;
    const auto system = MakeSystem(running);
    course.flaw = RandomRun(running, *system, seed).Run(steps);
    course.ending = !course.flaw.empty() ? Ending::kFlawed : system->Trouble() ? Ending::kUnstable : Ending::kOk;
  } catch (const UsageError&) {
    course = {.ending = Ending::kRefused};
  } catch (const TroubleError&) {
    course.ending = Ending::kUnstable;  // while it settled, before its clock started
  } catch (const std::exception& error) {
    course.ending = Ending::kFlawed;
    course.flaw = error.what();
  }
  course.seconds = watch.Seconds();
  return course;
}

}  // namespace sph
