#include "lab/stress.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "particles/diagnostics.hpp"

namespace sph {

std::span<const StressTest> AllStressTests() {
  static const std::array tests = {
      StressTest{"step-limit", "the longest stable step against theory, and what the adaptive step keeps of it",
                 &StressStepLimit},
      StressTest{"starts", "many random starts: unstable, outside, deepest", &StressStarts},
      StressTest{"size", "how deep the fluid sinks into walls, from a hundred to a million particles", &StressSize},
      StressTest{"length", "a million steps of a star, a hundred thousand of still water", &StressLength},
      StressTest{"rough", "rough handling: slammed walls, reversed gravity, coincident particles, ...", &StressRough},
      StressTest{"random", "random scenes over the whole schema", &StressRandom},
  };
  return tests;
}

double GreatestThatHolds(double low, double high, double accuracy, const std::function<bool(double)>& holds) {
  constexpr int kMostDoublings = 20;
  for (int k = 0; holds(high); ++k) {
    if (k == kMostDoublings) return kNoValue;
    low = high;
    high *= 2;
  }
  while (high > (1 + accuracy) * low) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

std::string FirstFlaw(const ParticleSystemSPH& system) {
  const Particles& p = system.State();
  std::vector<bool> seen(p.Size());
  for (std::size_t i = 0; i < p.Size(); ++i) {
    for (const double value : {p.x[i], p.y[i], p.vx[i], p.vy[i], p.vx_prev[i], p.vy_prev[i], p.mass[i]}) {
      if (!std::isfinite(value)) return fmt::format("particle {} has a {}", p.id[i], value);
    }
    if (p.id[i] >= p.Size() || seen[p.id[i]]) return fmt::format("particle {} is twice there", p.id[i]);
    seen[p.id[i]] = true;
  }
  for (const double density : system.Density()) {
    if (!std::isfinite(density)) return fmt::format("a density is {}", density);
  }
  const Diagnostics d = Diagnose(system);
  const std::pair<const char*, double> sums[] = {
      {"kinetic energy", d.kinetic_energy},     {"potential energy", d.potential_energy},
      {"internal energy", d.internal_energy},   {"momentum", d.momentum.x + d.momentum.y},
      {"angular momentum", d.angular_momentum}, {"centre of mass", d.centre_of_mass.x + d.centre_of_mass.y},
      {"highest speed", d.max_speed},           {"mean density", d.density.mean},
      {"deepest penetration", d.deepest},       {"time", system.Time()},
      {"step", system.parameters.time_step}};
  for (const auto& [name, value] : sums) {
    if (!std::isfinite(value)) return fmt::format("the {} is {}", name, value);
  }
  return {};
}

}  // namespace sph
