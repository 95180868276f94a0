// Run times of the passes, one by one, beside the paper's own loops in the same run:
// build/release/tests/sph/sphlab_passes_benchmark.
#include <benchmark/benchmark.h>

#include <cmath>

#include "lab/speed.hpp"
#include "scenes/build.hpp"
#include "sph/paper_loops.hpp"

namespace sph {
namespace {

/// The whole step of the fluid of `sphlab bench speed` on one thread; items are particle-steps.
void BM_Step(benchmark::State& state, Precision precision) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const auto system = MakeSystem(SpeedScene({n, 1, precision, "best"}));
  for (int k = 0; k < 20; ++k) system->Step();
  for (auto _ : state) system->Step();
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * system->State().Size()));
  for (const auto& [phase, seconds] : system->Phases().Seconds()) {
    state.counters[phase + " [ns]"] = 1e9 * seconds / static_cast<double>(system->Steps()) / static_cast<double>(n);
  }
}
BENCHMARK_CAPTURE(BM_Step, float, Precision::kFloat)->Arg(1000)->Arg(16000)->Arg(100000);
BENCHMARK_CAPTURE(BM_Step, double, Precision::kDouble)->Arg(1000)->Arg(16000)->Arg(100000);

/// The paper's two neighbour loops, and nothing else of a step, over the same particles.
void BM_PaperLoops(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const auto system = MakeSystem(SpeedScene({n, 1, Precision::kDouble, "best"}));
  for (int k = 0; k < 20; ++k) system->Step();
  const Particles& p = system->State();
  const auto& water = std::get<Tait>(system->parameters_sph.equation_of_state);
  PaperLoops loops(p.x, p.y, p.mass[0], system->parameters_sph.smoothing_length, water.k, water.rho0);
  for (auto _ : state) {
    loops.ComputePressures();
    loops.AddSpatialInteraction();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * n));
}
BENCHMARK(BM_PaperLoops)->Arg(1000)->Arg(16000)->Arg(100000);

}  // namespace
}  // namespace sph

BENCHMARK_MAIN();
