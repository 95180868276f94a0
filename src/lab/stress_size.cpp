// Walls under ever more particles: with the paper's constant stiffness the fluid sinks in with their number; with the
// derived one it does not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/stress.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

constexpr double kCollapse = 1.5;  // [s], in which the column comes down and is thrown back

/// How long a run may be: many particles only see the beginning of the collapse.
double Until(std::size_t particles, bool quick) {
  const double particle_steps = quick ? 3e6 : 3e8;
  const double n = static_cast<double>(particles);
  const double step = 0.004 * std::sqrt(600 / n);
  return std::min(kCollapse, particle_steps / n * step);
}

struct Sunk {
  double deepest = kNoValue;  // [spacings]
  double time = 0;            // [s]
  std::size_t outside = 0;
};

Sunk RunOf(std::size_t particles, const char* scaling, const StressOptions& options) {
  SceneRequest request;
  request.particles = particles;
  request.seed = options.FirstSeed();
  request.threads = options.threads;
  request.settings = {std::string("walls.scaling=") + scaling, "method.precision=float"};
  const Scene scene = LoadScene(request);
  const auto system = MakeSystem(scene);
  const double until = Until(particles, options.quick);
  while (system->Time() < until && !system->Trouble()) system->Step();
  const Diagnostics d = Diagnose(*system);
  return {system->Trouble() ? kNoValue : d.deepest, system->Time(), d.outside};
}

/// g H/(K dx^2): what the lowest layer of the column, as high as at the start, is pressed into a wall [spacings].
double Prediction(const Scene& scene) {
  const double height = scene.base.fluid.region.Bounds().Height();
  const double spacing = Spacing(scene.base.fluid);
  return -scene.base.gravity.y * height / (scene.base.wall.stiffness * spacing * spacing);
}

double Prediction(std::size_t particles, const char* scaling) {
  SceneRequest request;
  request.particles = particles;
  request.settings = {std::string("walls.scaling=") + scaling};
  return Prediction(LoadScene(request));
}

}  // namespace

void StressSize(const StressOptions& options, StressSink& sink) {
  std::vector<std::size_t> sizes = {100, 600, 2400, 10'000, 30'000, 100'000, 300'000, 1'000'000};
  if (options.quick) sizes.resize(3);
  std::string csv = "particles,scaling,deepest [spacings],until [s],outside,g H/(K dx^2)\n";
  std::vector<Series> series;
  for (const char* scaling : {"derived", "published"}) {
    std::vector<double> n, deepest, predicted;
    for (const std::size_t particles : sizes) {
      if (sink.Stopped()) return;
      sink.Note(fmt::format("size: {} walls, {} particles", scaling, particles));
      const Sunk sunk = RunOf(particles, scaling, options);
      n.push_back(static_cast<double>(particles));
      deepest.push_back(sunk.deepest);
      predicted.push_back(Prediction(particles, scaling));
      csv += fmt::format("{},{},{:.4g},{:.4g},{},{:.4g}\n", particles, scaling, sunk.deepest, sunk.time, sunk.outside,
                         predicted.back());
      const bool derived = std::string(scaling) == "derived";
      // What the paper's constant does is shown; the bar is of the walls that are to hold.
      sink.Row({fmt::format("dam-break, {} walls, N = {}, until {:.2g} s", scaling, particles, sunk.time),
                "deepest in a wall [spacings]", sunk.deepest, derived ? 0.5 : kNoBar,
                fmt::format("g H/(K dx^2) = {:.3g}; {} outside", predicted.back(), sunk.outside)});
    }
    series.push_back(Curve(fmt::format("{} walls", scaling), n, deepest));
    Series theory = Theory(fmt::format("g H/(K dx²), {}", scaling), n, predicted);
    if (series.size() > 1) theory.line = Line::kDotted;
    series.push_back(theory);
  }
  sink.Figure("size",
              {"Table II's dam: how deep the fluid sinks into its walls",
               {.label = "particles", .scale = Scale::kLog},
               {.label = "deepest penetration [spacings]", .scale = Scale::kLog},
               series,
               {}},
              csv);
}

}  // namespace sph
