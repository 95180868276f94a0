// Drops without walls: the one that becomes an ellipse, and the square that turns.
#include <algorithm>
#include <cmath>

#include "lab/fill_gauges.hpp"
#include "lab/verification.hpp"
#include "particles/diagnostics.hpp"

namespace sph {
namespace {

/// The drop of semi-axes a along x and b along y with the velocity (-A x, A y) under the force -lambda x: A' = (A^2 +
/// lambda) (a^2 - b^2)/(a^2 + b^2), a' = -A a, b' = A b [Monaghan & Rafiee 2013, eqs. 5.3 to 5.5].
struct Ellipse {
  double rate = 0, a = 1, b = 1;

  Ellipse Plus(double dt, const Ellipse& slope) const {
    return {rate + dt * slope.rate, a + dt * slope.a, b + dt * slope.b};
  }
  Ellipse Slope(double lambda) const {
    return {(rate * rate + lambda) * (a * a - b * b) / (a * a + b * b), -rate * a, rate * b};
  }
  /// By the classical Runge-Kutta method.
  void Advance(double dt, double lambda) {
    const Ellipse k1 = Slope(lambda);
    const Ellipse k2 = Plus(0.5 * dt, k1).Slope(lambda);
    const Ellipse k3 = Plus(0.5 * dt, k2).Slope(lambda);
    const Ellipse k4 = Plus(dt, k3).Slope(lambda);
    *this = Plus(dt / 6, k1).Plus(dt / 3, k2).Plus(dt / 3, k3).Plus(dt / 6, k4);
  }
};

/// Kinetic and central energy, and what compression stores [J/m].
double EnergyOf(const ParticleSystemSPH& system) {
  const Diagnostics d = Diagnose(system);
  return d.kinetic_energy + d.potential_energy + d.internal_energy;
}

/// b(t) of the elliptic drop, A = U/R.
double LongAxis(double rate, double time) {
  constexpr int kSteps = 10'000;
  Ellipse exact{rate, 1, 1};
  for (int k = 0; k < kSteps; ++k) exact.Advance(time / kSteps, 0);
  return exact.b;
}

double KineticEnergy(const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) sum += 0.5 * p.mass[i] * Dot(p.Velocity(i), p.Velocity(i));
  return sum;
}

std::vector<double> TimesOfEllipticDrop(const ParticleSystemSPH&) { return {0, 0.0076}; }

std::vector<Verdict> JudgeEllipticDrop(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots) {
  double axis_error = kBroken, energy_error = kBroken;
  if (!snapshots.empty()) {
    const FlowSnapshot& start = snapshots.front();
    const FlowSnapshot& end = snapshots.back();
    const double axis = std::sqrt(SecondMoments(end.particles).y / SecondMoments(start.particles).y);
    const double rate = flow.parameters_sph.flow_speed / (0.5 * flow.InitialBounds().Width());
    axis_error = axis / LongAxis(rate, end.time) - 1;
    energy_error = KineticEnergy(end.particles) / KineticEnergy(start.particles) - 1;
  }
  return {{"long axis at t = 0.0076 s, relative error", axis_error, 0.002,
           "ordinary differential equations; elsewhere 0.0103"},
          {"kinetic energy, relative error", energy_error, 0.005, "constant; elsewhere 0.031"}};
}

}  // namespace

const Judgement kEllipticDrop{&TimesOfEllipticDrop, &JudgeEllipticDrop};

std::vector<Verdict> MeasureEllipticDrop(ParticleSystemSPH& system) { return Judge(kEllipticDrop, system); }

std::vector<Verdict> MeasureOscillatingDrop(ParticleSystemSPH& system) {
  constexpr double kPeriod = 4.56737;  // of this rate and force, by the equations of Ellipse
  constexpr int kPeriods = 3;
  const Vec2 moments = SecondMoments(system.State());
  const double energy = EnergyOf(system);
  const double lambda = system.parameters.central_force;
  Ellipse exact{system.parameters_sph.flow_speed, 1, 1};
  Vec2 squares;
  long steps = 0;
  double before = 0;  // a - 1 at the last step
  double last_fall = 0;
  int falls = 0;
  while (falls < kPeriods && system.Time() < (kPeriods + 0.5) * kPeriod && !system.Trouble()) {
    const double then = system.Time();
    system.Step();
    const double dt = system.Time() - then;
    exact.Advance(dt, lambda);
    const Vec2 now_moments = SecondMoments(system.State());
    const double a = std::sqrt(now_moments.x / moments.x), b = std::sqrt(now_moments.y / moments.y);
    squares = squares + Vec2{(a - exact.a) * (a - exact.a), (b - exact.b) * (b - exact.b)};
    ++steps;
    const double now = a - 1;
    if (before > 0 && now <= 0) {
      last_fall = then + dt * before / (before - now);
      ++falls;
    }
    before = now;
  }
  const bool whole = falls == kPeriods;
  const double worse = std::max(squares.x, squares.y);
  return {{.metric = "worse axis, RMS error in three periods [m], R = 1 m",
           .value = whole ? std::sqrt(worse / static_cast<double>(steps)) : kBroken,
           .bar = 0.0034,
           .reference = "ordinary differential equations; elsewhere 0.0034 with R/dx = 200"},
          {.metric = "period, relative error",
           .value = whole ? last_fall / (kPeriods * kPeriod) - 1 : kBroken,
           .bar = 0.001,
           .reference = "4.56737 s"},
          {.metric = "energy, relative loss",
           .value = whole ? 1 - EnergyOf(system) / energy : kBroken,
           .bar = 0.01,
           .reference = "constant"}};
}

std::vector<Verdict> MeasureRotatingSquare(ParticleSystemSPH& system) {
  const double momentum = Diagnose(system).angular_momentum;
  AdvanceTo(system, 3);
  const double kept = Diagnose(system).angular_momentum / momentum;
  const double share = PairedShare(system.State(), 0.5 * system.InitialSpacing());
  const bool broken = system.Trouble().has_value();
  return {{.metric = "angular momentum at w t = 3, relative error",
           .value = broken ? kBroken : kept - 1,
           .bar = 0.003,
           .reference = "constant",
           .promise = {1, "the shifts of particles at the surface"}},
          {.metric = "share of paired particles",
           .value = broken ? kBroken : share,
           .bar = 0.02,
           .reference = "none; delta-SPH with shifting 0.044, without 0.213",
           .kind = MetricKind::kBounded}};
}

}  // namespace sph
