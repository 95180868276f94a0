// What the method promises to keep to round-off: momentum, where forces come in pairs, and the way back of leapfrog.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"
#include "sph/delta.hpp"
#include "sph/turning.hpp"

namespace sph {
namespace {

/// Sum of m v, and of m |v| [kg m/s], with the velocities half a step before: to those forces are added.
struct Momentum {
  Vec2 sum;
  double size = 0;
};
Momentum MomentumOf(const Particles& p) {
  Momentum momentum;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const Vec2 v{p.vx_prev[i], p.vy_prev[i]};
    momentum.sum = momentum.sum + p.mass[i] * v;
    momentum.size += p.mass[i] * Length(v);
  }
  return momentum;
}

}  // namespace

std::vector<Verdict> MeasureMomentum(ParticleSystemSPH& system) {
  const Momentum start = MomentumOf(system.State());
  AdvanceTo(system, 0.5);
  const Vec2 change = MomentumOf(system.State()).sum - start.sum;
  return {{.metric = "change of momentum until t = 0.5 s, relative",
           .value = system.Trouble() ? kBroken : Length(change) / start.size,
           .bar = 1e-12,
           .reference = "constant",
           .kind = MetricKind::kInvariant}};
}

/// There and back over half a period of the mode that stretches one axis and squeezes the other, omega^2 = 2 lambda:
/// over more of them particles that collide magnify round-off to any size.
std::vector<Verdict> MeasureReversal(ParticleSystemSPH& system) {
  Parameters steady = system.parameters;
  steady.adaptive_step = false;  // steps that differ on the way back are not the same steps
  Turning<Delta> star(steady, system.parameters_sph);
  star.Reset();
  const Particles& p = star.State();
  std::vector<Vec2> start(p.Size());
  for (std::size_t i = 0; i < p.Size(); ++i) start[p.id[i]] = p.Position(i);
  const double half_a_period = std::numbers::pi / std::sqrt(2 * star.parameters.central_force);
  const long steps = std::lround(half_a_period / star.parameters.time_step);
  const auto advance = [&] {
    for (long k = 0; k < steps && !star.Trouble(); ++k) star.Step();
  };
  advance();
  double furthest = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) furthest = std::max(furthest, Length(p.Position(i) - start[p.id[i]]));
  star.TurnRound();
  advance();
  double error = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) error = std::max(error, Length(p.Position(i) - start[p.id[i]]));
  return {{.metric = "back at the start, greatest distance over the way",
           .value = star.Trouble() ? kBroken : error / furthest,
           .bar = 1e-12,
           .reference = "0: leapfrog is reversible",
           .kind = MetricKind::kInvariant}};
}

}  // namespace sph
