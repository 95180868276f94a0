// The toy star against its exact density, and breathing against its exact radius.
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"
#include "sph/toy_star.hpp"

namespace sph {
namespace {

/// Table I: k = 0.1, M = 2 kg/m, R = 0.75 m.
constexpr ToyStar kStar{2.0, 0.75, 0.1};

/// x(t) = S(t) x(0) of every particle, S = diag(a, b): a'' = lambda (1/(a^2 b) - a), b'' = lambda (1/(a b^2) - b) [J.
/// J. Monaghan and D. J. Price, Mon. Not. R. Astron. Soc. 365 (2006) 991: the nonlinear solutions with a velocity
/// linear in x].
struct EllipticMotion {
  double a = 1, b = 1, da = 0, db = 0;

  EllipticMotion Plus(double dt, const EllipticMotion& slope) const {
    return {a + dt * slope.a, b + dt * slope.b, da + dt * slope.da, db + dt * slope.db};
  }
  EllipticMotion Slope(double lambda) const {
    return {da, db, lambda * (1 / (a * a * b) - a), lambda * (1 / (a * b * b) - b)};
  }
  /// By the classical Runge-Kutta method.
  void Advance(double dt, double lambda) {
    const EllipticMotion k1 = Slope(lambda);
    const EllipticMotion k2 = Plus(0.5 * dt, k1).Slope(lambda);
    const EllipticMotion k3 = Plus(0.5 * dt, k2).Slope(lambda);
    const EllipticMotion k4 = Plus(dt, k3).Slope(lambda);
    *this = Plus(dt / 6, k1).Plus(dt / 3, k2).Plus(dt / 3, k3).Plus(dt / 6, k4);
  }
};

/// Root mean square distances of the particles from where the motion takes them [m]: of all, by mass, and of those that
/// started within 0.8 R.
struct Distances {
  double all = 0, inner = 0;
};
Distances DistancesFrom(const EllipticMotion& motion, const std::vector<Vec2>& start, const Particles& p) {
  double squares = 0, mass = 0, inner_squares = 0, inner = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 from = start[p.id[i]];
    const Vec2 error = p.Position(i) - Vec2{motion.a * from.x, motion.b * from.y};
    squares += p.mass[i] * Dot(error, error);
    mass += p.mass[i];
    if (Length(from) > 0.8 * kStar.radius) continue;
    inner_squares += Dot(error, error);
    inner += 1;
  }
  return {std::sqrt(squares / mass), std::sqrt(inner_squares / inner)};
}

/// Sum of m x cross v [kg m/s], with velocities half a step before: of that leapfrog keeps every digit, as a step along
/// v does not change x cross v.
double AngularMomentum(const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) sum += p.mass[i] * (p.x[i] * p.vy_prev[i] - p.y[i] * p.vx_prev[i]);
  return sum;
}

}  // namespace

double StarErrorOf(double mse) { return std::sqrt(mse) / kStar.Density(0); }

std::vector<Verdict> MeasureStaticStar(ParticleSystemSPH& system, double bar, const std::string& reference) {
  AdvanceTo(system, 20);
  system.ComputeFields();
  const Particles& p = system.State();
  const double mse = system.Trouble() ? kBroken : CompareDensity(kStar, p.x, p.y, system.Density()).mse;
  return {{"mean square error of density at t = 20 s [kg^2/m^6]", mse, bar, reference,
           RelativeError{"RMS error of density over that in the centre", StarErrorOf(mse)}, MetricKind::kError,
           Promise{3, "in a band as wide as the kernel, h/R of the area, the kink at the edge leaves errors as h"}}};
}

/// b^2 = (2 + alpha^2)/2 - alpha^2/2 cos 2wt + alpha sin 2wt, w = sqrt(lambda), for v = alpha w x at b = 1. b^2 is the
/// second moment over that at the start.
std::vector<Verdict> MeasureBreathingStar(ParticleSystemSPH& system) {
  constexpr double kAlpha = 0.2;
  constexpr int kPeriods = 10;
  const double w = std::sqrt(kStar.CentralForce());
  const double period = std::numbers::pi / w;
  const double mean = 1 + 0.5 * kAlpha * kAlpha;
  const auto moment = [&] {
    const Vec2 sums = SecondMoments(system.State());
    return sums.x + sums.y;
  };
  const double start = moment();
  double worst = 0;
  double before = 0;  // b^2 - mean at the last step
  double first_rise = 0, last_rise = 0;
  int rises = 0;
  while (rises <= kPeriods && system.Time() < (kPeriods + 2) * period) {
    const double then = system.Time();
    system.Step();
    if (system.Trouble()) break;
    const double t = system.Time();
    const double square = moment() / start;
    const double exact = mean - 0.5 * kAlpha * kAlpha * std::cos(2 * w * t) + kAlpha * std::sin(2 * w * t);
    if (t <= kPeriods * period) worst = std::max(worst, std::abs(std::sqrt(square) - std::sqrt(exact)));
    const double now = square - mean;
    if (before < 0 && now >= 0) {
      last_rise = then + (t - then) * before / (before - now);
      if (rises++ == 0) first_rise = last_rise;
    }
    before = now;
  }
  const bool whole = rises == kPeriods + 1;
  const double measured = (last_rise - first_rise) / kPeriods;
  const Promise second{2, "sums of second order inside; the band at the edge that errs has h^2 of the mass"};
  return {{.metric = "period, relative error",
           .value = whole ? measured / period - 1 : kBroken,
           .bar = 0.001,
           .reference = "pi/sqrt(lambda); best elsewhere 0.00053",
           .promise = second,
           .finer_bar = 3e-4},
          {.metric = "radius, greatest error in ten periods, relative",
           .value = whole ? worst : kBroken,
           .bar = 0.002,
           .reference = "exact b(t); best elsewhere 0.0033",
           .promise = second,
           .finer_bar = 0.001}};
}

std::vector<Verdict> MeasureEllipticStar(ParticleSystemSPH& system) {
  constexpr int kPeriods = 5;
  const double lambda = kStar.CentralForce();
  // Of the mode that stretches one axis and squeezes the other: omega^2 = 2 lambda for small amplitudes.
  const double period = 2 * std::numbers::pi / std::sqrt(2 * lambda);
  const Particles& p = system.State();
  std::vector<Vec2> start(p.Size());
  for (std::size_t i = 0; i < p.Size(); ++i) start[p.id[i]] = p.Position(i);
  const double momentum = AngularMomentum(p);
  const double rate = system.parameters_sph.flow_speed / kStar.radius;
  EllipticMotion exact{.da = rate, .db = -rate};
  Distances worst;
  while (system.Time() < kPeriods * period && !system.Trouble()) {
    const double then = system.Time();
    system.Step();
    exact.Advance(system.Time() - then, lambda);
    const Distances now = DistancesFrom(exact, start, p);
    worst = {std::max(worst.all, now.all), std::max(worst.inner, now.inner)};
  }
  const bool broken = system.Trouble().has_value();
  const double turned =
      std::abs(AngularMomentum(p) - momentum) / (kStar.mass * kStar.radius * kStar.radius * std::sqrt(lambda));
  // The sum over a whole kernel cannot follow the kink of density at the edge, whose light particles are pushed about.
  return {{.metric = "place of particles from within 0.8 R, RMS over R",
           .value = broken ? kBroken : worst.inner / kStar.radius,
           .bar = 0.01,
           .reference = "exact S(t) x(0)",
           .promise = {2, "sums of second order inside"}},
          {.metric = "place of all, by mass, RMS over R",
           .value = broken ? kBroken : worst.all / kStar.radius,
           .bar = 0.04,
           .reference = "exact S(t) x(0)",
           .promise = {1, "a band at the edge as wide as the kernel has h^2 of the mass"}},
          {.metric = "angular momentum, change over M R^2 sqrt(lambda)",
           .value = broken ? kBroken : turned,
           .bar = 1e-12,
           .reference = "constant",
           .kind = MetricKind::kInvariant}};
}

}  // namespace sph
