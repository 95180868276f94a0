// Long runs: what is conserved stays where it was for a million steps, and water that rests goes on resting.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/stress.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

std::unique_ptr<ParticleSystemSPH> SystemOf(const std::string& scene, std::size_t particles,
                                            std::vector<std::string> settings, int threads) {
  SceneRequest request;
  request.scene = scene;
  request.particles = particles;
  request.settings = std::move(settings);
  request.threads = threads;
  return MakeSystem(LoadScene(request));
}

/// Of the star at one moment, relative to the start.
struct Sample {
  double step;
  double energy;    ///< (E - E0)/E0
  double momentum;  ///< (L - L0) over sum m r v
  double swing;     ///< of the centre of mass: how much its amplitude has changed, over R
};

/// What leapfrog keeps, formed from what it steps: places at the step, velocities half a step before it.
class StarSeries {
 public:
  explicit StarSeries(ParticleSystemSPH& system) : system_(system) {
    const Particles& p = system.State();
    for (std::size_t i = 0; i < p.Size(); ++i) scale_ += p.mass[i] * Length(p.Position(i)) * Length(p.Velocity(i));
    system_.Step();  // the first half step is not a whole one
    energy_ = Energy();
    momentum_ = AngularMomentum();
    amplitude_ = Amplitude();
  }

  Sample Now() {
    return {static_cast<double>(system_.Steps()), Energy() / energy_ - 1, (AngularMomentum() - momentum_) / scale_,
            (Amplitude() - amplitude_) / kRadius};
  }

 private:
  static constexpr double kRadius = 0.75;  // [m]

  /// With v = v(t - dt/2) + a dt/2.
  double Energy() {
    system_.ComputeFields();
    const Particles& p = system_.State();
    const double half = 0.5 * system_.parameters.time_step;
    double kinetic = 0, central = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const Vec2 v{p.vx_prev[i] + half * p.ax[i], p.vy_prev[i] + half * p.ay[i]};
      kinetic += 0.5 * p.mass[i] * Dot(v, v);
      central += 0.5 * p.mass[i] * system_.parameters.central_force * Dot(p.Position(i), p.Position(i));
    }
    return kinetic + central + system_.InternalEnergy();
  }

  /// sum m x(t) x v(t - dt/2): central forces and forces along pairs do not change it, in any number of steps.
  double AngularMomentum() const {
    const Particles& p = system_.State();
    double sum = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) sum += p.mass[i] * (p.x[i] * p.vy_prev[i] - p.y[i] * p.vx_prev[i]);
    return sum;
  }

  /// The centre of mass is on a spring, X' = V, V' = -lambda X, whatever the pressure does. Leapfrog keeps
  /// V(t - dt/2)^2 + lambda X(t).X(t - dt) exactly.
  double Amplitude() const {
    const Particles& p = system_.State();
    Vec2 x, v;
    double mass = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      x = x + p.mass[i] * p.Position(i);
      v = v + p.mass[i] * Vec2{p.vx_prev[i], p.vy_prev[i]};
      mass += p.mass[i];
    }
    x = (1 / mass) * x;
    v = (1 / mass) * v;
    const Vec2 before = x - system_.parameters.time_step * v;
    return std::sqrt(Dot(v, v) / system_.parameters.central_force + Dot(x, before));
  }

  ParticleSystemSPH& system_;
  double energy_ = 0, momentum_ = 0, amplitude_ = 0;
  double scale_ = 0;
};

/// Greatest |value| of samples whose step is in ]first, last].
double Envelope(const std::vector<Sample>& samples, double first, double last, double Sample::*value) {
  double greatest = 0;
  for (const Sample& sample : samples) {
    if (sample.step > first && sample.step <= last) greatest = std::max(greatest, std::abs(sample.*value));
  }
  return greatest;
}

double Mean(const std::vector<Sample>& samples, double first, double last) {
  double sum = 0;
  int count = 0;
  for (const Sample& sample : samples) {
    if (sample.step <= first || sample.step > last) continue;
    sum += sample.energy;
    ++count;
  }
  return count == 0 ? 0 : sum / count;
}

void OfStar(const StressOptions& options, StressSink& sink) {
  constexpr std::size_t kParticles = 300;
  const double last = options.quick ? 1e4 : 1e6;
  constexpr double kFirst = 1000;
  const auto system = SystemOf("breathing-star", kParticles, {}, options.threads);
  StarSeries series(*system);
  std::vector<Sample> samples;
  const long apart = options.quick ? 10 : 200;
  while (static_cast<double>(system->Steps()) < last && !system->Trouble() && !sink.Stopped()) {
    system->Step();
    const bool early = static_cast<double>(system->Steps()) <= kFirst;
    if (early || system->Steps() % apart == 0) samples.push_back(series.Now());
    if (system->Steps() % 10'000 == 0) sink.Note(fmt::format("length: star, step {}", system->Steps()));
  }
  if (sink.Stopped()) return;
  const std::string what = fmt::format("breathing-star, N = {}, {:.0e} steps", system->State().Size(), last);
  const bool whole = !system->Trouble();
  // Leapfrog conserves an energy near E: E itself swings round it with the star. The bound is that swing.
  const double bound = Envelope(samples, 0, kFirst, &Sample::energy);
  const double swing = Envelope(samples, kFirst, last, &Sample::energy);
  sink.Row({what, "|dE/E| over that of the first 1000 steps", whole ? swing / bound : kNoValue, 1,
            fmt::format("{:.3g}, in the first 1000 steps {:.3g}", swing, bound)});
  const double drift = Mean(samples, 0.9 * last, last) - Mean(samples, kFirst, 0.1 * last + kFirst);
  sink.Row({what, "drift of mean E/E, last to first tenth", whole ? std::abs(drift) : kNoValue, bound});
  const double round_off = 1e-16 * std::sqrt(last) * 100;
  sink.Row({what, "angular momentum, relative", whole ? Envelope(samples, 0, last, &Sample::momentum) : kNoValue,
            round_off, "bar: a random walk of round-off"});
  sink.Row({what, "swing of the centre of mass, change over R",
            whole ? Envelope(samples, 0, last, &Sample::swing) : kNoValue, round_off});
  std::vector<double> step, energy;
  std::string csv = "step,dE/E,angular momentum,swing of the centre of mass over R\n";
  for (const Sample& sample : samples) {
    step.push_back(sample.step);
    energy.push_back(sample.energy);
    csv += fmt::format("{:.0f},{:.6g},{:.6g},{:.6g}\n", sample.step, sample.energy, sample.momentum, sample.swing);
  }
  sink.Figure("length-star",
              {"Energy of a breathing star of 300 particles",
               {.label = "step", .scale = Scale::kLog},
               {.label = "dE/E"},
               {Scatter("a thousand steps, then samples", step, energy), Theory("bound", {1, last}, {bound, bound}),
                Theory("", {1, last}, {-bound, -bound})},
               {}},
              csv);
}

void OfWater(const StressOptions& options, StressSink& sink) {
  constexpr std::size_t kParticles = 720;  // 40 x 18: the lattice fits the tank
  const long last = options.quick ? 4000 : 100'000;
  const auto system = SystemOf("still-water", kParticles, {}, options.threads);
  const double unit = [&] {  // M g H [J/m]
    const Particles& p = system->State();
    double mass = 0;
    for (const double m : p.mass) mass += m;
    return -mass * system->parameters.gravity.y * system->parameters.fluid.region.box.Height();
  }();
  // The greatest of each decade's steps.
  std::vector<double> step, kinetic;
  std::string csv = "step,kinetic energy over M g H\n";
  double greatest = 0;
  double next = 10;
  while (system->Steps() < last && !system->Trouble() && !sink.Stopped()) {
    system->Step();
    greatest = std::max(greatest, Diagnose(*system).kinetic_energy / unit);
    if (static_cast<double>(system->Steps()) < next && system->Steps() < last) continue;
    step.push_back(static_cast<double>(system->Steps()));
    kinetic.push_back(greatest);
    csv += fmt::format("{},{:.6g}\n", system->Steps(), greatest);
    greatest = 0;
    next *= std::pow(10, 0.25);
  }
  if (sink.Stopped()) return;
  const std::string what = fmt::format("still-water, N = {}, {} steps", system->State().Size(), last);
  // Speeds of an ulp of g dt at every step, from all neighbours' pressures: (1e-16 p/(rho h) dt)^2 and below.
  constexpr double kFloor = 1e-24;
  double worst_rise = 0;  // of an interval over the one a decade before
  for (std::size_t k = 8; k < kinetic.size(); ++k) {
    worst_rise = std::max(worst_rise, kinetic[k] / std::max(kFloor, kinetic[k - 4]));
  }
  sink.Row({what, "kinetic energy over that a decade of steps before", system->Trouble() ? kNoValue : worst_rise, 1,
            fmt::format("ends at {:.2g} M g H; floor of round-off {:.0e}", kinetic.back(), kFloor)});
  sink.Figure("length-water",
              {"Water at rest: its greatest kinetic energy in a quarter of a decade of steps",
               {.label = "step", .scale = Scale::kLog},
               {.label = "kinetic energy over M g H", .scale = Scale::kLog},
               {Curve("still-water, 720 particles", step, kinetic)},
               {}},
              csv);
}

}  // namespace

void StressLength(const StressOptions& options, StressSink& sink) {
  OfStar(options, sink);
  if (!sink.Stopped()) OfWater(options, sink);
}

}  // namespace sph
