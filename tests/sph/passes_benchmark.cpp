// Run times of the passes, one by one, beside the paper's own loops in the same run:
// build/release/tests/sph/sphlab_passes_benchmark.
#include <benchmark/benchmark.h>

#include "base/clock.hpp"
#include "lab/speed.hpp"
#include "scenes/build.hpp"
#include "sph/paper_loops.hpp"

namespace sph {
namespace {

std::unique_ptr<ParticleSystemSPH> Tank(std::int64_t n, Precision precision) {
  Scene scene = SpeedScene(Flow::kTank, static_cast<std::size_t>(n), precision);
  scene.base.threads = 1;
  auto system = MakeSystem(scene);
  WarmUp(*system, Flow::kTank);
  return system;
}

PaperLoops LoopsOver(const ParticleSystemSPH& system) {
  const Particles& p = system.State();
  const auto& water = std::get<Tait>(system.parameters_sph.equation_of_state);
  return {p.x, p.y, p.mass[0], system.parameters_sph.smoothing_length, water.k, water.rho0};
}

/// The whole step of the tank of `sphlab bench speed` on one thread; items are particle-steps.
void BM_Step(benchmark::State& state, Precision precision) {
  const auto system = Tank(state.range(0), precision);
  const auto before = system->Phases().Seconds();
  for (auto _ : state) system->Step();
  const double particle_steps = static_cast<double>(state.iterations() * state.range(0));
  state.SetItemsProcessed(static_cast<std::int64_t>(particle_steps));
  for (const auto& [phase, seconds] : system->Phases().Seconds()) {
    const auto then = before.find(phase);
    state.counters[phase + " [ns]"] = 1e9 * (seconds - (then == before.end() ? 0 : then->second)) / particle_steps;
  }
}
BENCHMARK_CAPTURE(BM_Step, float, Precision::kFloat)->Arg(1000)->Arg(16000)->Arg(100000);
BENCHMARK_CAPTURE(BM_Step, double, Precision::kDouble)->Arg(1000)->Arg(16000)->Arg(100000);

/// The paper's two neighbour loops, and nothing else of a step, over the same particles.
void BM_PaperLoops(benchmark::State& state) {
  PaperLoops loops = LoopsOver(*Tank(state.range(0), Precision::kDouble));
  for (auto _ : state) {
    loops.ComputePressures();
    loops.AddSpatialInteraction();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_PaperLoops)->Arg(1000)->Arg(16000)->Arg(100000);

/// Steps and the paper's loops in turns, so that both meet the same noise: how many times as fast the whole step is.
void BM_StepsAndPaperLoopsInTurns(benchmark::State& state, Precision precision) {
  const auto system = Tank(state.range(0), precision);
  PaperLoops loops = LoopsOver(*system);
  double of_steps = 0;  // [s]
  double of_loops = 0;
  for (auto _ : state) {
    Stopwatch watch;
    system->Step();
    of_steps += watch.Seconds();
    watch.Restart();
    loops.ComputePressures();
    loops.AddSpatialInteraction();
    of_loops += watch.Seconds();
  }
  state.counters["loops over step"] = of_loops / of_steps;
}
BENCHMARK_CAPTURE(BM_StepsAndPaperLoopsInTurns, float, Precision::kFloat)->Arg(1000)->Arg(16000)->Arg(100000);
BENCHMARK_CAPTURE(BM_StepsAndPaperLoopsInTurns, double, Precision::kDouble)->Arg(1000)->Arg(16000)->Arg(100000);

/// The tank with h = 2 dx, which is 50 neighbours.
std::unique_ptr<ParticleSystemSPH> WideTank(std::int64_t n, Precision precision, const char* solver) {
  Scene scene = SpeedScene(Flow::kTank, static_cast<std::size_t>(n), precision);
  scene.base.threads = 1;
  scene.solver = solver;
  scene.sph.smoothing_length *= 2 / 1.3;
  auto system = MakeSystem(scene);
  WarmUp(*system, Flow::kTank);
  return system;
}

/// The whole step of solver delta, and the density and pressure passes of the paper's, in turns.
void BM_DeltasStepAndThePapersPassesInTurns(benchmark::State& state, Precision precision) {
  const auto delta = WideTank(state.range(0), precision, "delta"), paper = WideTank(state.range(0), precision, "paper");
  const auto of_passes = [&] {
    return paper->Phases().Seconds().at("density") + paper->Phases().Seconds().at("pressure");
  };
  const double before = of_passes();
  double of_delta = 0;  // [s]
  for (auto _ : state) {
    const Stopwatch watch;
    delta->Step();
    of_delta += watch.Seconds();
    paper->Step();
  }
  state.counters["step over passes"] = of_delta / (of_passes() - before);
  state.counters["neighbours of delta"] = delta->MeanNeighbours();
  state.counters["of paper"] = paper->MeanNeighbours();
}
BENCHMARK_CAPTURE(BM_DeltasStepAndThePapersPassesInTurns, float, Precision::kFloat)->Arg(16000)->Arg(100000);
BENCHMARK_CAPTURE(BM_DeltasStepAndThePapersPassesInTurns, double, Precision::kDouble)->Arg(16000)->Arg(100000);

}  // namespace
}  // namespace sph

BENCHMARK_MAIN();
