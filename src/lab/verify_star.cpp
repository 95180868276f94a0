// The toy star against its exact density, and breathing against its exact radius.
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"
#include "sph/toy_star.hpp"

namespace sph {
namespace {

/// Table I: k = 0.1, M = 2 kg/m, R = 0.75 m.
constexpr ToyStar kStar{2.0, 0.75, 0.1};

}  // namespace

std::vector<Verdict> MeasureStaticStar(ParticleSystemSPH& system, double bar, const std::string& reference) {
  AdvanceTo(system, 20);
  system.ComputeFields();
  const Particles& p = system.State();
  const double mse = system.Trouble() ? kBroken : CompareDensity(kStar, p.x, p.y, system.Density()).mse;
  return {{"mean square error of density at t = 20 s [kg^2/m^6]", mse, bar, reference}};
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
  return {{"period, relative error", whole ? std::abs(measured / period - 1) : kBroken, 0.0002,
           "pi/sqrt(lambda); best elsewhere 0.00053"},
          {"radius, greatest error in ten periods, relative", whole ? worst : kBroken, 0.0015,
           "exact b(t); best elsewhere 0.0033"}};
}

}  // namespace sph
