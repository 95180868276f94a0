#include "lab/speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "base/clock.hpp"
#include "base/instruction_set.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

constexpr int kRepetitions = 5;
constexpr double kParticleStepsPerRepetition = 4e6;

/// Density and acceleration of particle i by the scalar kernel in double precision, over the particles of its cluster's
/// list.
struct Twin {
  double density = 0;
  Vec2 acceleration;
};

class ScalarTwin {
 public:
  explicit ScalarTwin(const ParticleSystemSPH& system)
      : system_(system), kernel_(system.parameters_sph.smoothing_length), density_(system.State().Size(), -1) {}

  Twin Of(std::uint32_t i, std::span<const std::uint32_t> near,
          const std::function<std::span<const std::uint32_t>(std::uint32_t)>& list) {
    const Particles& p = system_.State();
    const double own = Term(i, near);
    Twin twin{density_[i], system_.parameters.gravity};
    for (const std::uint32_t j : near) {
      const Vec2 apart = p.Position(i) - p.Position(j);
      const double r = Length(apart);
      if (j == i || r >= system_.Support()) continue;
      twin.acceleration = twin.acceleration - p.mass[j] * (own + Term(j, list(j))) * kernel_.Gradient(r) * apart;
    }
    return twin;
  }

 private:
  /// P/rho^2 of particle i.
  double Term(std::uint32_t i, std::span<const std::uint32_t> near) {
    const Particles& p = system_.State();
    if (density_[i] < 0) {
      density_[i] = 0;
      for (const std::uint32_t j : near)
        density_[i] += p.mass[j] * kernel_.Value(Length(p.Position(i) - p.Position(j)));
    }
    const double rho = density_[i];
    return std::get<Tait>(system_.parameters_sph.equation_of_state).Pressure(rho) / (rho * rho);
  }

  const ParticleSystemSPH& system_;
  CubicSpline<2> kernel_;
  std::vector<double> density_;  // -1 where not known yet
};

void MeasureErrors(const ParticleSystemSPH& system, SpeedResult& result) {
  const NeighbourSearch& search = system.Neighbours();
  const auto clusters = search.Clusters();
  std::vector<std::uint32_t> cluster_of(system.State().Size());
  for (std::uint32_t k = 0; k < clusters.size(); ++k) {
    for (std::uint32_t i = 0; i < clusters[k].count; ++i) cluster_of[clusters[k].first + i] = k;
  }
  const auto list = [&](std::uint32_t i) {
    return search.Blocks()[cluster_of[i] / kClustersPerBlock].Of(cluster_of[i]);
  };
  ScalarTwin twin(system);
  const std::vector<double> density = system.Density();
  const Particles& p = system.State();
  const std::size_t stride = std::max<std::size_t>(1, p.Size() / 1000);
  double greatest_density = 0;
  double greatest_acceleration = 0;
  for (std::uint32_t i = 0; i < p.Size(); i += static_cast<std::uint32_t>(stride)) {
    const Twin exact = twin.Of(i, list(i), list);
    greatest_density = std::max(greatest_density, exact.density);
    greatest_acceleration = std::max(greatest_acceleration, Length(exact.acceleration));
    result.density_error = std::max(result.density_error, std::abs(density[i] - exact.density));
    result.acceleration_error =
        std::max(result.acceleration_error, Length(Vec2{p.ax[i], p.ay[i]} - exact.acceleration));
  }
  result.density_error /= greatest_density;
  result.acceleration_error /= greatest_acceleration;
}

}  // namespace

/// The fluid fills 2 m x 1 m; its waves are a fifth as fast as its sound.
Scene SpeedScene(const SpeedCase& of) {
  Scene scene;
  scene.name = "speed";
  const double dx = std::sqrt(2.0 / static_cast<double>(of.particles));
  Parameters& base = scene.base;
  base.fluid.particles = of.particles;
  base.fluid.region.box = {0, 0, 2, 1};
  base.fluid.arrange = Arrangement::kJittered;
  base.fluid.jitter = 0.2 * dx;
  base.particle_mass = dx * dx;
  base.gravity = {0, -1};
  base.walls = {{"left", FluidSide::kRight, 0, 0, 0, 0},
                {"right", FluidSide::kLeft, 2, 0, 2, 2},
                {"floor", FluidSide::kAbove, 0, 0, 0, 0}};
  base.wall = {WallKind::kPenalty, 4 / (dx * dx), 1 / dx, 0};
  constexpr double kSound = 5;
  base.time_step = 0.4 * 1.3 * dx / kSound;
  base.threads = of.threads;
  scene.sph.smoothing_length = 1.3 * dx;
  scene.sph.equation_of_state = Tait{kSound * kSound / 7, 1, 7};
  scene.sph.precision = of.precision;
  return scene;
}

SpeedResult MeasureSpeed(const SpeedCase& of) {
  UseInstructionSet(of.instruction_set, "bench");
  const auto system = MakeSystem(SpeedScene(of));
  if (!of.keep_lists) system->KeepLists(false);
  SpeedResult result;
  result.of = of;
  const auto n = static_cast<double>(system->State().Size());
  result.steps = std::max(3L, std::lround(kParticleStepsPerRepetition / n));
  const long warm_up = std::min(result.steps, 50L);
  for (long step = 0; step < warm_up; ++step) system->Step();
  const double per_particle_step = 1e9 / (n * static_cast<double>(result.steps));
  std::vector<double> times;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    const auto before = system->Phases().Seconds();
    const Stopwatch watch;
    for (long step = 0; step < result.steps; ++step) system->Step();
    times.push_back(watch.Seconds() * per_particle_step);
    if (times.back() > *std::min_element(times.begin(), times.end())) continue;
    const auto spent = [&](const char* phase) {
      const auto& after = system->Phases().Seconds();
      const auto now = after.find(phase);
      const auto then = before.find(phase);
      return now == after.end() ? 0.0 : (now->second - (then == before.end() ? 0 : then->second)) * per_particle_step;
    };
    result.grid_ns = spent("grid");
    result.density_ns = spent("density");
    result.pressure_ns = spent("pressure");
    result.walls_ns = spent("walls");
    result.integrate_ns = spent("integrate");
  }
  std::sort(times.begin(), times.end());
  result.repetitions = kRepetitions;
  result.least_ns = times.front();
  result.median_ns = times[times.size() / 2];
  result.greatest_ns = times.back();
  system->ComputeFields();
  result.neighbours = system->MeanNeighbours();
  result.bytes = static_cast<double>(system->Bytes()) / n;
  MeasureErrors(*system, result);
  UseInstructionSet("best", "bench");
  return result;
}

std::vector<SpeedCase> SpeedCases(bool quick) {
  const std::vector<std::size_t> sizes = quick ? std::vector<std::size_t>{1000, 10'000}
                                               : std::vector<std::size_t>{1000, 10'000, 100'000, 1'000'000, 4'000'000};
  std::vector<SpeedCase> cases;
  for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
    for (const std::string& set : AvailableInstructionSets()) {
      const bool best = set == AvailableInstructionSets().back();
      for (const int threads : best ? std::vector<int>{1, 2} : std::vector<int>{1}) {
        for (const std::size_t n : sizes) cases.push_back({n, threads, precision, set});
      }
    }
    // What keeping the lists saves.
    for (const std::size_t n : sizes) cases.push_back({n, 1, precision, AvailableInstructionSets().back(), false});
  }
  return cases;
}

namespace {

std::string NameOf(const SpeedCase& of) {
  return fmt::format("{}, {}, {} thread{}{}", of.precision == Precision::kFloat ? "float" : "double",
                     of.instruction_set, of.threads, of.threads == 1 ? "" : "s",
                     of.keep_lists ? "" : ", lists at every step");
}

}  // namespace

std::string SpeedAsCsv(const std::vector<SpeedResult>& results) {
  std::string text =
      "particles,threads,precision,instruction_set,lists_kept,steps,repetitions,least [ns],median [ns],greatest [ns],"
      "particle_steps_per_second [1/s],grid [ns],density [ns],pressure [ns],walls [ns],integrate [ns],neighbours,"
      "memory [bytes],density_error,acceleration_error\n";
  for (const SpeedResult& r : results) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{:.2f},{:.2f},{:.2f},{:.4g},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.0f},{:.2e},{:."
        "2e}\n",
        r.of.particles, r.of.threads, r.of.precision == Precision::kFloat ? "float" : "double", r.of.instruction_set,
        r.of.keep_lists ? 1 : 0, r.steps, r.repetitions, r.least_ns, r.median_ns, r.greatest_ns, 1e9 / r.least_ns,
        r.grid_ns, r.density_ns, r.pressure_ns, r.walls_ns, r.integrate_ns, r.neighbours, r.bytes, r.density_error,
        r.acceleration_error);
  }
  return text;
}

Plot SpeedPlot(const std::vector<SpeedResult>& results) {
  Plot plot;
  plot.title = "Particle-steps per second, about 20 neighbours";
  plot.x = {"particles", Scale::kLog};
  plot.y = {"million particle-steps per second", Scale::kLog};
  std::map<std::string, Series> by_name;
  std::vector<std::string> order;
  for (const SpeedResult& r : results) {
    const std::string name = NameOf(r.of);
    if (!by_name.contains(name)) {
      by_name[name] = Curve(name, {}, {});
      order.push_back(name);
    }
    by_name[name].x.push_back(static_cast<double>(r.of.particles));
    by_name[name].y.push_back(1e3 / r.least_ns);
  }
  for (const std::string& name : order) plot.series.push_back(by_name[name]);
  return plot;
}

}  // namespace sph
