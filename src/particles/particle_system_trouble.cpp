// How a ParticleSystem finds that a start or a step has broken down, and what it says of it.
#include <cmath>

#include "particles/particle_system.hpp"

namespace sph {

std::string Instability::Message() const {
  return fmt::format(
      "step {}, t = {:.6g} s: particle {} at ({:.4g}, {:.4g}) m with velocity ({:.4g}, {:.4g}) m/s: {}{}", step, time,
      id, position.x, position.y, velocity.x, velocity.y, limit, advice.empty() ? "" : "; " + advice);
}

void ParticleSystem::StopAt(const Breach& breach) {
  const Particles& p = particles_;
  const std::size_t i = breach.particle;
  trouble_ = Instability{steps_, time_, p.id[i], p.Position(i), {p.vx_prev[i], p.vy_prev[i]}, breach.limit, {}};
}

namespace {

/// Of a place [m] or velocity [m/s]: small enough for sums of squares, times whatever mass, to be numbers.
bool IsSomewhere(Vec2 v) {
  constexpr double kFarthest = 1e120;
  return std::abs(v.x) < kFarthest && std::abs(v.y) < kFarthest;
}

}  // namespace

std::optional<ParticleSystem::Breach> ParticleSystem::FindBrokenStart() const {
  const Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    if (!IsSomewhere(p.Position(i))) return Breach{i, "its position is not a number or too large"};
    if (!IsSomewhere(p.Velocity(i))) return Breach{i, "its velocity is not a number or too large"};
    if (!(p.mass[i] > 0 && std::isfinite(p.mass[i]))) return Breach{i, "its mass is not a number above 0"};
  }
  return std::nullopt;
}

std::optional<ParticleSystem::Breach> ParticleSystem::FindBrokenForces() const {
  const Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    if (std::isfinite(p.ax[i] + p.ay[i] + p.vx_prev[i] + p.vy_prev[i])) continue;
    return Breach{i, "the forces on it at the start are not numbers"};
  }
  return std::nullopt;
}

std::optional<ParticleSystem::Breach> ParticleSystem::FindMoveTooFar() const {
  const Particles& p = particles_;
  const double longest = LongestMove();
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double moved = std::hypot(p.vx_prev[i], p.vy_prev[i]) * parameters.time_step;
    const bool in_order = moved <= longest && IsSomewhere(p.Position(i));
    if (!in_order && (!first || p.id[i] < p.id[*first])) first = i;
  }
  if (!first) return std::nullopt;
  const double speed = std::hypot(p.vx_prev[*first], p.vy_prev[*first]);
  if (!std::isfinite(speed)) {
    return Breach{*first,
                  fmt::format("its velocity is not a number; the step of {:.3g} s is too long for the forces of "
                              "this scene",
                              parameters.time_step)};
  }
  if (speed * parameters.time_step <= longest) return Breach{*first, "its position is not a number or too large"};
  return Breach{*first, fmt::format("it moved further in the step than the support radius of {:.3g} m; the step was "
                                    "{:.3g} s, and only one below {:.3g} s would have held it",
                                    longest, parameters.time_step, longest / speed)};
}

}  // namespace sph
