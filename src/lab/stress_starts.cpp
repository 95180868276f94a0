// Many random starts of the paper's two scenes: how many break down, leak, or sink into walls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/stress.hpp"
#include "particles/diagnostics.hpp"
#include "particles/guard.hpp"
#include "scenes/build.hpp"
#include "scenes/changes.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

/// A scene that runs until `until`, with a key at `press_at` if there is one.
struct KeyedScene {
  std::string scene;
  std::string key;
  double press_at = 0;  // [s]
  double until = 0;
};

struct Outcome {
  bool unstable = false;
  int retreats = 0;
  std::size_t outside = 0;
  double deepest = 0;  // [spacings]
};

Outcome RunOf(const KeyedScene& course, std::uint64_t seed, int threads) {
  SceneRequest request;
  request.scene = course.scene;
  request.seed = seed;
  request.threads = threads;
  Scene scene = LoadScene(request);
  const auto system = MakeSystem(scene);
  Guard guard(*system, scene.retries);
  bool pressed = course.key.empty();
  while (system->Time() < course.until && !system->Trouble()) {
    if (!pressed && system->Time() >= course.press_at) {
      PressSceneKey(course.key, scene, *system);
      guard.Mark();
      pressed = true;
    }
    guard.Step();
  }
  const Diagnostics d = Diagnose(*system);
  return {system->Trouble().has_value(), guard.Retreats(), d.outside, d.deepest};
}

/// How many of the runs came to at most so deep.
void Draw(const std::string& name, const std::string& title, std::vector<double> deepest, StressSink& sink) {
  std::ranges::sort(deepest);
  std::vector<double> share;
  std::string csv = "deepest [spacings],share of the starts\n";
  for (std::size_t k = 0; k < deepest.size(); ++k) {
    share.push_back(static_cast<double>(k + 1) / static_cast<double>(deepest.size()));
    csv += fmt::format("{:.5g},{:.5g}\n", deepest[k], share.back());
  }
  Series runs = Curve("starts", deepest, share);
  runs.marker = Marker::kNone;
  sink.Figure(
      name,
      {title,
       {.label = "deepest penetration of a wall [spacings]", .low = 0, .high = std::max(0.6, 1.1 * deepest.back())},
       {.label = "share of the starts", .low = 0, .high = 1},
       {runs, Theory("bar", {0.5, 0.5}, {0, 1})},
       {}},
      csv);
}

void OfScene(const KeyedScene& course, const StressOptions& options, StressSink& sink) {
  const long count = options.CountOr(1000, 6);
  long unstable = 0, outside = 0, retreats = 0;
  double deepest = 0;
  std::uint64_t of_deepest = options.FirstSeed();
  std::vector<double> depths;
  for (long k = 0; k < count && !sink.Stopped(); ++k) {
    const std::uint64_t seed = options.FirstSeed() + static_cast<std::uint64_t>(k);
    sink.Note(fmt::format("starts: {} seed {}", course.scene, seed));
    const Outcome outcome = RunOf(course, seed, options.threads);
    unstable += outcome.unstable ? 1 : 0;
    retreats += outcome.retreats;
    outside += static_cast<long>(outcome.outside);
    if (!(outcome.deepest <= deepest)) of_deepest = seed;
    deepest = std::max(deepest, outcome.deepest);
    depths.push_back(outcome.deepest);
  }
  if (sink.Stopped()) return;
  const std::string what =
      fmt::format("{}, {} seeds from {} on, until {} s{}", course.scene, count, options.FirstSeed(), course.until,
                  course.key.empty() ? "" : fmt::format(", {} at {} s", course.key, course.press_at));
  sink.Row(
      {what, "unstable runs", static_cast<double>(unstable), 0, fmt::format("{} steps undone and halved", retreats)});
  sink.Row({what, "particles outside", static_cast<double>(outside), 0});
  sink.Row({what, "deepest in a wall [spacings]", deepest, 0.5, fmt::format("seed {}", of_deepest)});
  Draw("starts-" + course.scene, fmt::format("{} random starts of {}", count, course.scene), depths, sink);
}

}  // namespace

void StressStarts(const StressOptions& options, StressSink& sink) {
  OfScene({"toy-star", "", 0, 6}, options, sink);
  if (!sink.Stopped()) OfScene({"dam-break", "d", 4, 6}, options, sink);
}

}  // namespace sph
