// The longest stable step, found by bisection, against theory; the adaptive step beside it; maps of stable and not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "lab/lattice_waves.hpp"
#include "lab/stress.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

constexpr double kAccuracy = 0.002;  // of a bisection
constexpr double kTheoryBar = 0.05;
constexpr double kMarginBar = 0.8;

/// A fluid at rest on an endless square lattice of spacing 1, with the speed of sound 1 and without anything that
/// damps.
struct LatticeFluid {
  std::string what;
  std::string solver;
  SmoothingKernel kernel = SmoothingKernel::kWendlandC2;  ///< of solver delta
  bool gas = false;                                       ///< P = k rho^2
  double h = 1.3;                                         ///< smoothing length, of mueller the support, in spacings
};

const std::vector<LatticeFluid> kFluids = {
    {"delta, Wendland C2, liquid, h/dx = 1.3", "delta", SmoothingKernel::kWendlandC2, false, 1.3},
    {"delta, Wendland C2, liquid, h/dx = 2", "delta", SmoothingKernel::kWendlandC2, false, 2.0},
    {"delta, Wendland C4, liquid, h/dx = 2", "delta", SmoothingKernel::kWendlandC4, false, 2.0},
    {"delta, Wendland C2, gas, h/dx = 1.3", "delta", SmoothingKernel::kWendlandC2, true, 1.3},
    {"delta, Wendland C2, gas, h/dx = 1.4", "delta", SmoothingKernel::kWendlandC2, true, 1.4},
    {"delta, Wendland C2, gas, h/dx = 2", "delta", SmoothingKernel::kWendlandC2, true, 2.0},
    {"delta, Wendland C4, gas, h/dx = 2", "delta", SmoothingKernel::kWendlandC4, true, 2.0},
    {"paper, cubic spline, liquid, h/dx = 1.3", "paper", {}, false, 1.3},
    {"paper, cubic spline, gas, h/dx = 1.2", "paper", {}, true, 1.2},
    {"mueller, Poly6 and Spiky, support/dx = 1.75", "mueller", {}, false, 1.75},
};

/// Particles on the lattice's sites with random velocities of a millionth of the speed of sound: all waves at once, and
/// so little that the waves that nothing drives back leave the lattice as it is.
std::shared_ptr<const GivenStart> NoisyLattice(int across) {
  constexpr double kNoise = 1e-6;
  auto start = std::make_shared<GivenStart>();
  Random random(1);
  for (int row = 0; row < across; ++row) {
    for (int column = 0; column < across; ++column) {
      start->particles.Add({column + 0.5, row + 0.5},
                           {random.Uniform(-kNoise, kNoise), random.Uniform(-kNoise, kNoise)}, 1);
    }
  }
  return start;
}

Scene SceneOf(const LatticeFluid& fluid, double time_step, int threads) {
  const int across = static_cast<int>(std::ceil(std::max(20.0, 8 * fluid.h)));
  Scene scene;
  scene.name = "lattice";
  scene.solver = fluid.solver;
  scene.sph.smoothing_length = fluid.h;
  if (fluid.gas) {
    scene.sph.equation_of_state = Polytrope{0.5};
  } else if (fluid.solver == "paper") {
    scene.sph.equation_of_state = Tait{1.0 / 7, 1, 7};
  } else {
    scene.sph.equation_of_state = IdealGas{1, 1};
  }
  scene.sph.delta = {.kernel = fluid.kernel, .diffusion = 0, .sound_damping = 0, .shifting = false};
  scene.sph.periods.box = {0, 0, static_cast<double>(across), static_cast<double>(across)};
  scene.sph.periods.in_x = scene.sph.periods.in_y = true;
  Parameters& base = scene.base;
  base.fluid.particles = static_cast<std::size_t>(across) * static_cast<std::size_t>(across);
  base.fluid.region.box = scene.sph.periods.box;
  base.given = NoisyLattice(across);
  base.particle_mass = 1;
  base.time_step = time_step;
  base.threads = threads;
  return scene;
}

/// With the density that the sum over the lattice gives as the reference, so that there is no pressure.
std::unique_ptr<ParticleSystemSPH> SystemOf(const LatticeFluid& fluid, double time_step, int threads,
                                            bool adaptive = false) {
  Scene scene = SceneOf(fluid, time_step, threads);
  scene.base.adaptive_step = adaptive;
  if (!fluid.gas && fluid.solver != "delta") {
    const double summed = Diagnose(*MakeSystem(scene)).density.mean;
    if (fluid.solver == "paper") {
      scene.sph.equation_of_state = Tait{summed / 7, summed, 7};
    } else {
      scene.sph.equation_of_state = IdealGas{1, summed};
    }
  }
  return MakeSystem(scene);
}

double Fastest(const ParticleSystem& system) {
  const Particles& p = system.State();
  double fastest2 = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    fastest2 = std::max(fastest2, p.vx_prev[i] * p.vx_prev[i] + p.vy_prev[i] * p.vy_prev[i]);
  }
  return std::sqrt(fastest2);
}

/// The highest speed that a system comes to in so many steps, but not much more than `enough`.
double HighestSpeed(ParticleSystemSPH& system, long steps, double enough) {
  double highest = 0;
  for (long k = 0; k < steps && highest < enough; ++k) {
    system.Step();
    if (system.Trouble()) return kNoValue;
    highest = std::max(highest, Fastest(system));
  }
  return highest;
}

constexpr double kBlownUp = 0.3;  // of the speed of sound: no wave of the start comes near
constexpr long kStepsOfALattice = 400;

bool Holds(const LatticeFluid& fluid, double time_step, int threads) {
  return HighestSpeed(*SystemOf(fluid, time_step, threads), kStepsOfALattice, kBlownUp) < kBlownUp;
}

double SoundSpeedOf(const ParticleSystemSPH& system) {
  const std::vector<double> density = system.Density();
  const double densest = *std::ranges::max_element(density);
  return std::visit([&](const auto& equation) { return equation.SoundSpeed(densest); },
                    system.parameters_sph.equation_of_state);
}

struct LatticeTheory {
  double limit = 0;   ///< c dt/h
  double growth = 0;  ///< of waves that leave the lattice; where there are some, the limit is that of no fluid
};

LatticeTheory TheoryOf(const LatticeFluid& fluid) {
  if (fluid.solver == "mueller") {
    return {StableStep(GreatestFrequency(Poly6OfUnitLength(), SpikyOfUnitLength(), fluid.h)),
            GreatestGrowth(Poly6OfUnitLength(), SpikyOfUnitLength(), fluid.h)};
  }
  const RadialKernel kernel = fluid.solver == "paper"                        ? CubicSplineOfUnitLength()
                              : fluid.kernel == SmoothingKernel::kWendlandC2 ? WendlandC2OfUnitLength()
                                                                             : WendlandC4OfUnitLength();
  const LatticeWaves waves{fluid.h, fluid.gas ? 0.5 : 0.0, fluid.gas || fluid.solver == "paper"};
  return {StableStep(GreatestFrequency(kernel, waves)), GreatestGrowth(kernel, waves)};
}

void Compare(const std::string& what, double measured, double theory, const std::string& unit, StressSink& sink) {
  sink.Row({what, "off theory, relative", std::abs(measured / theory - 1), kTheoryBar,
            fmt::format("{} {:.3f}, theory {:.3f}", unit, measured, theory)});
}

void Margin(const std::string& what, double adaptive, double limit, StressSink& sink) {
  sink.Row({what, "adaptive step over the measured limit", adaptive / limit, kMarginBar,
            fmt::format("{:.3g} s of {:.3g} s", adaptive, limit)});
}

/// The longest step that an adaptive run comes to, once it has grown as far as it may.
double LongestAdaptive(ParticleSystemSPH& system, int steps) {
  double longest = 0;
  for (int k = 0; k < steps && !system.Trouble(); ++k) {
    system.Step();
    longest = std::max(longest, system.parameters.time_step);
  }
  return system.Trouble() ? kNoValue : longest;
}

void OnLattices(const StressOptions& options, StressSink& sink) {
  for (const LatticeFluid& fluid : kFluids) {
    if (sink.Stopped()) return;
    const auto [theory, growth] = TheoryOf(fluid);
    const double sound = SoundSpeedOf(*SystemOf(fluid, 0.1, options.threads));
    const double limit =
        GreatestThatHolds(0.5 * theory * fluid.h, 1.3 * theory * fluid.h, options.quick ? 0.01 : kAccuracy,
                          [&](double dt) { return Holds(fluid, dt, options.threads); });
    constexpr double kSlow = 0.1;  // c/h: in 400 steps the particles hardly leave the lattice
    if (growth < kSlow) Compare(fluid.what, limit * sound / fluid.h, theory, "c dt/h", sink);
    Margin(fluid.what, LongestAdaptive(*SystemOf(fluid, 0.1 * fluid.h, options.threads, true), 60), limit, sink);
  }
}

/// A single particle, which nothing but the scene's forces acts on.
Parameters OneParticle() {
  Parameters one;
  one.fluid.particles = 1;
  one.fluid.region.box = {0, 0, 1, 1};
  one.particle_mass = 1;
  one.threads = 1;
  return one;
}

/// The step, over the spring's 1/omega, with which a particle that is a little off the place where it could rest stays
/// near it.
double LimitOfASpring(Parameters one, Vec2 rest, double omega) {
  auto start = std::make_shared<GivenStart>();
  start->particles.Add(rest + Vec2{1e-6, 1e-6}, {}, one.particle_mass);
  one.given = start;
  const ParametersSPH fluid{1, Polytrope{1}};
  return GreatestThatHolds(1 / omega, 4 / omega, kAccuracy,
                           [&](double dt) {
                             one.time_step = dt;
                             ParticleSystemSPH system(one, fluid);
                             system.Reset();
                             for (int k = 0; k < 2000; ++k) {
                               system.Step();
                               if (system.Trouble() || Length(system.State().Position(0) - rest) > 1e-3) return false;
                             }
                             return true;
                           }) *
         omega;
}

void OnSprings(StressSink& sink) {
  constexpr double kStiffness = 20000, kLambda = 0.5;
  Parameters central = OneParticle();
  central.central_force = kLambda;
  Compare("central force, one particle", LimitOfASpring(central, {}, std::sqrt(kLambda)), 2, "sqrt(lambda) dt", sink);
  // Two, so that it does not come out of them.
  Parameters walls = OneParticle();
  walls.wall.stiffness = kStiffness;
  walls.walls = {{"floor", FluidSide::kAbove, 1, 0, 1, 1}, {"ceiling", FluidSide::kBelow, -1, 0, -1, -1}};
  Compare("two penalty walls, one particle deep in both", LimitOfASpring(walls, {}, std::sqrt(2 * kStiffness)), 2,
          "sqrt(2 K) dt", sink);
}

/// A scene as it is at a time: all further runs start there.
Scene SceneAt(const SceneRequest& request, double time) {
  Scene scene = LoadScene(request);
  const auto system = MakeSystem(scene);
  while (system->Time() < time && !system->Trouble()) system->Step();
  system->ComputeFields();
  scene.base.given = std::make_shared<GivenStart>(GivenStart{system->State(), system->Density()});
  return scene;
}

/// Scenes that have come to rest, and go on with a longer step.
void OnSettledScenes(const StressOptions& options, StressSink& sink) {
  struct Settled {
    std::string scene;
    double time;  // [s], after which it is at rest
  };
  for (const Settled& settled : {Settled{"dam-break", 4}, Settled{"toy-star", 20}, Settled{"water-column", 0}}) {
    if (sink.Stopped()) return;
    SceneRequest request;
    request.scene = settled.scene;
    request.particles = options.quick ? 200 : 600;
    request.threads = options.threads;
    Scene scene = SceneAt(request, settled.time);
    const double calm = 10 * Fastest(*MakeSystem(scene)) + std::sqrt(9.8 * scene.base.fluid.region.Bounds().Height());
    const double first = scene.base.time_step;
    scene.base.adaptive_step = false;
    const double limit = GreatestThatHolds(0.5 * first, 4 * first, 0.01, [&](double dt) {
      scene.base.time_step = dt;
      return HighestSpeed(*MakeSystem(scene), 400, 3 * calm) < 3 * calm;
    });
    scene.base.time_step = 0.1 * first;
    scene.base.adaptive_step = true;
    Margin(fmt::format("{} from t = {} s on, N = {}", settled.scene, settled.time, *request.particles),
           LongestAdaptive(*MakeSystem(scene), 100), limit, sink);
  }
}

/// On a map: white, so that it is seen on dark and on bright cells.
Series OnMap(Line line, std::string name, std::vector<double> x, std::vector<double> y) {
  Series series = Theory(std::move(name), std::move(x), std::move(y));
  series.line = line;
  series.colour = Colour{1, 1, 1};
  return series;
}

/// Step against resolution: the highest speed that waves of a thousandth come to.
void MapOfLattices(const StressOptions& options, StressSink& sink) {
  const std::size_t columns = options.quick ? 3 : 14, rows = options.quick ? 4 : 22;
  const Box extent{1.2, 1.0, 2.6, 2.1};
  HeatMap map{
      columns, rows, {}, extent, {.label = "highest speed over c", .scale = Scale::kLog, .low = 1e-3, .high = 1}};
  std::string csv = "h/dx,c dt/h,highest speed over c\n";
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns && !sink.Stopped(); ++column) {
      const auto middle = [](std::size_t k, std::size_t n) {
        return (static_cast<double>(k) + 0.5) / static_cast<double>(n);
      };
      const LatticeFluid fluid{"", "delta", SmoothingKernel::kWendlandC2, false,
                               extent.x0 + extent.Width() * middle(column, columns)};
      const double step = extent.y0 + extent.Height() * middle(row, rows);
      const double highest =
          std::min(1.0, HighestSpeed(*SystemOf(fluid, step * fluid.h, options.threads), kStepsOfALattice, 1));
      map.values.push_back(highest);
      csv += fmt::format("{:.4g},{:.4g},{:.4g}\n", fluid.h, step, highest);
    }
  }
  if (sink.Stopped()) return;
  std::vector<double> x, y;
  for (double h = extent.x0; h <= extent.x1 + 1e-9; h += 0.05) {
    x.push_back(h);
    y.push_back(StableStep(GreatestFrequency(WendlandC2OfUnitLength(), {h, 0})));
  }
  const Series theory = OnMap(Line::kDashed, "theory: omega dt = 2", x, y);
  sink.Figure("step-limit-lattice",
              {"A liquid on a lattice, Wendland C2, 400 steps of leapfrog",
               {.label = "h/dx", .low = extent.x0, .high = extent.x1},
               {.label = "c dt/h", .low = extent.y0, .high = extent.y1},
               {theory},
               {},
               map},
              csv);
}

/// How fast Table II's dam gets in its first second, with so many particles and so long a step.
double SpeedOfADam(std::size_t particles, double time_step, int threads) {
  SceneRequest request;
  request.particles = particles;
  request.threads = threads;
  Scene scene = LoadScene(request);
  scene.base.time_step = time_step;
  const auto system = MakeSystem(scene);
  double highest = 0;
  while (system->Time() < 1) {
    system->Step();
    if (system->Trouble()) return kNoValue;
    highest = std::max(highest, Fastest(*system));
  }
  return highest;
}

void MapOfDams(const StressOptions& options, StressSink& sink) {
  const std::size_t columns = options.quick ? 2 : 6, rows = options.quick ? 3 : 14;
  const Box extent{100, 1e-3, options.quick ? 400.0 : 6400.0, 5e-2};
  const double free_fall = std::sqrt(2 * 9.8 * 0.95);  // [m/s], from the top to the floor
  HeatMap map{columns,
              rows,
              {},
              extent,
              {.label = "highest speed over sqrt(2 g H)", .scale = Scale::kLog, .low = 0.1, .high = 10}};
  std::string csv = "particles,dt [s],highest speed over sqrt(2 g H)\n";
  const auto at = [](double low, double high, std::size_t k, std::size_t n) {
    return low * std::pow(high / low, (static_cast<double>(k) + 0.5) / static_cast<double>(n));
  };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns && !sink.Stopped(); ++column) {
      const double n = std::round(at(extent.x0, extent.x1, column, columns));
      const double step = at(extent.y0, extent.y1, row, rows);
      sink.Note(fmt::format("step-limit: dam of {} particles, dt = {:.3g} s", n, step));
      const double highest =
          std::min(10.0, SpeedOfADam(static_cast<std::size_t>(n), step, options.threads) / free_fall);
      map.values.push_back(highest);
      csv += fmt::format("{},{:.4g},{:.4g}\n", n, step, highest);
    }
  }
  if (sink.Stopped()) return;
  SceneRequest request;
  const Scene published = LoadScene(request);
  // Of the settled column's floor, up to 1.75 times the reference density.
  const double sound = std::get<Tait>(published.sph.equation_of_state).SoundSpeed(1.75 * 2.861);
  const double of_sound =
      StableStep(GreatestFrequency(CubicSplineOfUnitLength(), {2.2, 1.0 / 7})) * published.sph.smoothing_length / sound;
  const double of_walls = 2 / std::sqrt(published.base.wall.stiffness);
  std::vector<double> x = {extent.x0, extent.x1}, walls, both, table;
  for (const double n : x) {
    const double finer = std::sqrt(600 / n);
    walls.push_back(of_walls * finer);
    both.push_back(finer / std::hypot(1 / of_sound, 1 / of_walls));
    table.push_back(published.base.time_step * finer);
  }
  sink.Figure("step-limit-dam",
              {"The first second of Table II's dam",
               {.label = "particles", .scale = Scale::kLog, .low = extent.x0, .high = extent.x1},
               {.label = "dt [s]", .scale = Scale::kLog, .low = extent.y0, .high = extent.y1},
               {OnMap(Line::kDotted, "walls: sqrt(K) dt = 2", x, walls),
                OnMap(Line::kDashed, "walls and sound", x, both), OnMap(Line::kSolid, "Table II", x, table)},
               {},
               map},
              csv);
}

}  // namespace

void StressStepLimit(const StressOptions& options, StressSink& sink) {
  OnLattices(options, sink);
  OnSprings(sink);
  OnSettledScenes(options, sink);
  MapOfLattices(options, sink);
  MapOfDams(options, sink);
}

}  // namespace sph
