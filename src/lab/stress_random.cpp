// Random scenes: each is refused, or runs for some tens of steps and ends well, or unstable with its cause named.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "lab/random_scene.hpp"
#include "lab/stress.hpp"
#include "particles/guard.hpp"
#include "scenes/build.hpp"
#include "scenes/changes.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

enum class Ending { kRefused, kOk, kUnstable, kFlawed };

struct Course {
  Ending ending = Ending::kOk;
  std::string flaw = {};
  double seconds = 0;
};

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

/// What a person may do meanwhile.
std::size_t Disturb(Scene& scene, ParticleSystemSPH& system, Random& random) {
  constexpr std::size_t kMost = 500;  // of a block that is dropped ten thousand times
  const double choice = random.Uniform();
  try {
    if (choice < 0.3) PressSceneKey("d", scene, system);
  } catch (const UsageError&) {
    return 0;  // the fluid does not bear it
  }
  if (choice > 0.3 && choice < 0.5 && system.parameters.drop.particles < kMost && system.DropBlock().empty()) {
    return system.parameters.drop.particles;
  }
  if (Wall* wall = FindWall(system.parameters.walls, scene.arrow_wall); choice > 0.5 && wall != nullptr) {
    wall->velocity = choice < 0.75 ? -scene.arrow_speed : scene.arrow_speed;
  }
  return 0;
}

std::string Run(Scene& scene, ParticleSystemSPH& system, Guard& guard, Random& random) {
  constexpr int kSteps = 40;
  std::size_t expected = system.State().Size();
  for (int k = 0; k < kSteps && !system.Trouble(); ++k) {
    if (k == kSteps / 2) {
      expected += Disturb(scene, system, random);
      guard.Mark();
    }
    guard.Step();
  }
  guard.ComputeFields();
  if (system.State().Size() != expected) return fmt::format("{} particles of {}", system.State().Size(), expected);
  if (system.Trouble() && system.Trouble()->limit.empty()) return "unstable without a cause";
  return FirstFlaw(system);
}

Course CourseOf(std::uint64_t seed, int threads) {
  const Stopwatch watch;
  Course course;
  try {
    Scene scene = Load(MakeRandomScene(seed), seed, threads);
    const auto system = MakeSystem(scene);
    Guard guard(*system, scene.retries);
    Random random(seed);
    course.flaw = Run(scene, *system, guard, random);
    course.ending = !course.flaw.empty() ? Ending::kFlawed : system->Trouble() ? Ending::kUnstable : Ending::kOk;
  } catch (const UsageError&) {
    course.ending = Ending::kRefused;
  } catch (const TroubleError&) {
    course.ending = Ending::kUnstable;  // while it settled, before its clock started
  } catch (const std::exception& error) {
    course = {Ending::kFlawed, error.what()};
  }
  course.seconds = watch.Seconds();
  return course;
}

}  // namespace

void StressRandom(const StressOptions& options, StressSink& sink) {
  constexpr unsigned kPatience = 60;  // [s]
  const long count = options.CountOr(10'000, 150);
  if (count == 1) sink.Say(Describe(MakeRandomScene(options.seed)));  // to be repeated by hand
  std::array<long, 4> endings{};
  std::string first_flaw;
  double slowest = 0;
  std::uint64_t of_slowest = options.seed;
  for (long k = 0; k < count; ++k) {
    if (sink.Stopped()) return;
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(k);
    sink.Note(fmt::format("random: seed {}", seed), kPatience);
    const Course course = CourseOf(seed, options.threads);
    ++endings[static_cast<std::size_t>(course.ending)];
    if (course.ending == Ending::kFlawed && first_flaw.empty()) {
      first_flaw = fmt::format("seed {}: {}", seed, course.flaw);
    }
    if (course.seconds > slowest) of_slowest = seed;
    slowest = std::max(slowest, course.seconds);
  }
  const auto number = [&](Ending ending) { return endings[static_cast<std::size_t>(ending)]; };
  const std::string what = fmt::format("{} scenes, seeds from {} on", count, options.seed);
  sink.Row({what, "flawed: not a number, lost, no cause", static_cast<double>(number(Ending::kFlawed)), 0,
            fmt::format("{} ok, {} unstable, {} refused{}{}", number(Ending::kOk), number(Ending::kUnstable),
                        number(Ending::kRefused), first_flaw.empty() ? "" : "; first flaw: ", first_flaw)});
  sink.Row({what, "slowest [s]", slowest, 10, fmt::format("seed {}", of_slowest)});
}

}  // namespace sph
