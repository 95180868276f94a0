// What the walls do to the particles of a ParticleSystem: the penalty force, and the tutorial's reflection.
#include <algorithm>

#include "particles/particle_system.hpp"

namespace sph {
namespace {

bool Inside(const Box& box, double x, double y) { return x >= box.x0 && x <= box.x1 && y >= box.y0 && y <= box.y1; }

}  // namespace

double ParticleSystem::Boundaries(std::size_t i) {
  Particles& p = particles_;
  const double before =
      0.5 * previous_step_;  // v- is as long before t as half the last step, v+ after it half the next
  const double after = 0.5 * parameters.time_step;
  double deepest = 0;
  double damping = 0;  // [1/s], of all the walls that the particle is in
  for (const Wall& wall : parameters.walls) {
    const double depth = wall.Depth(p.Position(i));
    if (depth <= 0) continue;
    deepest = std::max(deepest, depth);
    const Vec2 push = parameters.wall.stiffness * depth * wall.Normal();
    const double speed = wall.velocity * parameters.wall.damping;  // damping is relative to the wall
    p.ax[i] += push.x + (wall.Vertical() ? speed : 0.0);
    p.ay[i] += push.y + (wall.Vertical() ? 0.0 : speed);
    damping += parameters.wall.damping;
  }
  if (damping == 0) return deepest;
  if (parameters.integration != Integration::kLeapFrog) {
    p.ax[i] -= damping * p.vx[i];
    p.ay[i] -= damping * p.vy[i];
    return deepest;
  }
  // Integrate knows the motion damping nu only. This is the acceleration with which its step comes out as the step of
  // the second-order form with n = nu + damping: v+ = [v- (1 - n before) + a (before + after)]/(1 + n after).
  const double nu = parameters.motion_damping;
  const double span = before + after;
  const auto damped = [&](double a, double v_prev) {
    const double wanted = (v_prev * (1 - (nu + damping) * before) + a * span) / (1 + (nu + damping) * after);
    return (wanted * (1 + nu * after) - v_prev * (1 - nu * before)) / span;
  };
  p.ax[i] = damped(p.ax[i], p.vx_prev[i]);
  p.ay[i] = damped(p.ay[i], p.vy_prev[i]);
  return deepest;
}

void ParticleSystem::AddWallForces() {
  if (parameters.walls.empty() || parameters.wall.kind != WallKind::kPenalty) return;
  const Box legal = LegalRegion(parameters.walls);
  // A wall that was moved by hand since the last step, or new particles: what that step noted no longer holds.
  if (legal != legal_ || notes_.empty()) notes_.assign(ChunkCount(), {.behind_wall = true});
  if (std::ranges::none_of(notes_, &ChunkNotes::behind_wall)) return;
  const PhaseTimer timer(phases_, "walls");
  ForEachChunk([&](std::size_t chunk, std::size_t first, std::size_t last) {
    if (!notes_[chunk].behind_wall) return;
    double deepest = 0;
    for (std::size_t i = first; i < last; ++i) {
      if (!Inside(legal, particles_.x[i], particles_.y[i])) deepest = std::max(deepest, Boundaries(i));
    }
    notes_[chunk].deepest = deepest;
  });
  for (const ChunkNotes& notes : notes_) deepest_ = std::max(deepest_, notes.deepest);
}

/// The penalty force acts on a particle that was behind a wall when the step began. One that went in during the step
/// gets here what the wall does to it from that moment on; without it a particle of Table II's dam, shot at the far
/// wall, is 0.6 spacings deep before it feels it. The damping along the wall starts with the next step.
void ParticleSystem::CatchAtWalls(std::size_t first, std::size_t last) {
  constexpr double kRoundOff = 1 + 1e-9;
  const double dt = parameters.time_step;
  Particles& p = particles_;
  for (std::size_t i = first; i < last; ++i) {
    if (Inside(legal_, p.x[i], p.y[i])) continue;
    for (const Wall& wall : parameters.walls) {
      double& position = wall.Vertical() ? p.x[i] : p.y[i];
      double& velocity = wall.Vertical() ? p.vx[i] : p.vy[i];
      double& previous = wall.Vertical() ? p.vx_prev[i] : p.vy_prev[i];
      const double inwards = -(wall.Normal().x + wall.Normal().y);
      const double depth = inwards * (position - wall.at);
      const double speed = inwards * (previous - wall.velocity);
      if (depth <= 0 || depth > speed * dt * kRoundOff) continue;  // in the fluid, or inside when the step began
      const double since = depth / speed;                          // [s], since it went in
      const Penetration now = PenetrationAfter(parameters.wall, speed, since);
      const Penetration half_a_step_ago = PenetrationAfter(parameters.wall, speed, std::max(0.0, since - 0.5 * dt));
      position = wall.at + inwards * now.depth;
      velocity = wall.velocity + inwards * now.speed;
      previous = wall.velocity + inwards * half_a_step_ago.speed;
    }
  }
}

void ParticleSystem::ReflectFromWalls() {
  if (parameters.walls.empty() || parameters.wall.kind == WallKind::kPenalty) return;
  if (std::ranges::none_of(notes_, &ChunkNotes::behind_wall)) return;
  const PhaseTimer timer(phases_, "walls");
  Particles& p = particles_;
  const double restitution = parameters.wall.kind == WallKind::kReflect ? parameters.wall.restitution : 0.0;
  const BoundingWalls bounding(parameters.walls);  // who is behind another one is behind these, and reflected once
  for (const Wall* bounds : bounding.All()) {
    if (bounds == nullptr) continue;
    const Wall& wall = *bounds;
    auto& position = wall.Vertical() ? p.x : p.y;
    auto& velocity = wall.Vertical() ? p.vx : p.vy;
    auto& previous = wall.Vertical() ? p.vx_prev : p.vy_prev;
    for (std::size_t chunk = 0; chunk < notes_.size(); ++chunk) {
      if (!notes_[chunk].behind_wall) continue;
      for (std::size_t i = chunk * kParticlesPerChunk; i < std::min(p.Size(), (chunk + 1) * kParticlesPerChunk); ++i) {
        if (wall.Depth(p.Position(i)) <= 0) continue;
        position[i] = wall.at;
        for (double* v : {&velocity[i], &previous[i]}) *v = wall.velocity - restitution * (*v - wall.velocity);
      }
    }
  }
}

}  // namespace sph
