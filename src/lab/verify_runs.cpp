#include "lab/verify_runs.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/clock.hpp"
#include "lab/resolutions.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

/// A run of a case, as placed.
struct Run {
  std::size_t particles = 0;
  double seconds = 0;
  std::vector<Verdict> verdicts = {};
};

Run RunScene(const VerificationCase& of, const Scene& scene) {
  const auto system = MakeSystem(scene);
  const Stopwatch watch;
  std::vector<Verdict> verdicts = of.measure(*system);
  return {system->State().Size(), watch.Seconds(), std::move(verdicts)};
}

std::size_t OwnParticles(const VerificationCase& of) { return LoadScene(of.request).base.fluid.particles; }

bool HasAny(const std::vector<Verdict>& verdicts, MetricKind kind) {
  return std::ranges::find(verdicts, kind, &Verdict::kind) != verdicts.end();
}

/// The start that a seed makes of the scene's: of a lattice, one that is perturbed by up to a tenth of its spacing.
void Disturb(Scene& scene, std::uint64_t seed) {
  scene.base.seed = seed;
  Block& fluid = scene.base.fluid;
  if (fluid.arrange != Arrangement::kLattice) return;
  fluid.arrange = Arrangement::kPerturbed;
  fluid.jitter = 0.1 * Spacing(fluid);
}

/// Runs with few particles and different starts, for how much chance does.
std::vector<Run> RunSeeds(const VerificationCase& of, std::size_t particles, int threads) {
  constexpr std::uint64_t kSeeds = 5;
  std::vector<Run> runs;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Scene scene = SceneOf(of, particles, threads);
    Disturb(scene, seed);
    runs.push_back(RunScene(of, scene));
  }
  return runs;
}

std::vector<double> ValuesOf(const std::vector<Run>& runs, std::size_t metric) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const Run& run : runs) values.push_back(run.verdicts[metric].value);
  return values;
}

/// A metric of all runs, or of the case's own where its kind takes no other.
Judged JudgeMetric(const std::vector<Run>& runs, std::size_t own, const std::vector<Run>& seeds, std::size_t metric) {
  const Verdict& verdict = runs[own].verdicts[metric];
  if (verdict.kind != MetricKind::kError && verdict.kind != MetricKind::kBounded) {
    return JudgeLevels(verdict, {{runs[own].particles, verdict.value}}, 0, {});
  }
  std::vector<Level> levels;
  levels.reserve(runs.size());
  for (const Run& run : runs) levels.push_back({run.particles, run.verdicts[metric].value});
  return JudgeLevels(verdict, std::move(levels), own, ValuesOf(seeds, metric));
}

}  // namespace

std::vector<std::size_t> LadderOf(const VerificationCase& of, bool whole) {
  constexpr double kNear = 2;
  const Block fluid = LoadScene(of.request).base.fluid;
  const auto own = static_cast<double>(fluid.particles);
  const bool fills = IsLatticeInBox(fluid) && NearestFilling(fluid.region.box, own, kNear) == fluid.particles;
  const auto near = [&](double wanted) {
    const std::size_t filling = fills ? NearestFilling(fluid.region.box, wanted, kNear) : 0;
    return filling > 0 ? filling : static_cast<std::size_t>(std::llround(wanted));
  };
  std::vector<std::size_t> numbers;
  for (const double share : of.shares) {
    if (share <= 1 || whole) numbers.push_back(share == 1 ? fluid.particles : near(share * own));
  }
  if (!whole) numbers.erase(numbers.begin(), numbers.end() - 2);
  return numbers;
}

Scene SceneOf(const VerificationCase& of, std::size_t particles, int threads) {
  SceneRequest request = of.request;
  request.particles = particles;
  request.threads = threads;
  Scene scene = LoadScene(request);
  if (of.change != nullptr) of.change(scene);
  return scene;
}

CaseResult RunCase(const VerificationCase& of, const LadderOptions& options) {
  const auto run = [&](std::size_t particles) { return RunScene(of, SceneOf(of, particles, options.threads)); };
  const std::size_t own_particles = OwnParticles(of);
  Run own = run(own_particles);
  CaseResult result{SceneOf(of, own_particles, options.threads).solver, own.particles, own.seconds};
  const bool bounded = HasAny(own.verdicts, MetricKind::kBounded);
  const bool laddered = bounded || HasAny(own.verdicts, MetricKind::kError);
  std::vector<Run> runs, seeds;
  std::size_t own_index = 0;
  for (const std::size_t particles : laddered ? LadderOf(of, options.whole) : std::vector{own_particles}) {
    if (particles == own_particles) own_index = runs.size();
    runs.push_back(particles == own_particles ? own : run(particles));
    SPH_CHECK(runs.back().verdicts.size() == own.verdicts.size(), "{} metrics of {}, not {}",
              runs.back().verdicts.size(), of.name, own.verdicts.size());
    if (bounded && runs.size() == 1) seeds = RunSeeds(of, particles, options.threads);
  }
  for (std::size_t k = 0; k < own.verdicts.size(); ++k) {
    result.metrics.push_back(JudgeMetric(runs, own_index, seeds, k));
  }
  return result;
}

}  // namespace sph
