#include "particles/particle_system.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"

namespace sph {

std::string Instability::Message() const {
  return fmt::format("step {}, t = {:.6g} s: particle {} at ({:.4g}, {:.4g}) m with velocity ({:.4g}, {:.4g}) m/s: {}",
                     step, time, id, position.x, position.y, velocity.x, velocity.y, limit);
}

ParticleSystem::ParticleSystem(const Parameters& start) : parameters(start), initial_parameters_(start) {
  SPH_CHECK(start.time_step > 0, "dt = {}", start.time_step);
  SPH_CHECK(start.particle_mass > 0, "m = {}", start.particle_mass);
}

void ParticleSystem::RestoreParameters() { parameters = initial_parameters_; }

void ParticleSystem::Reset() {
  RestoreParameters();
  trouble_.reset();
  time_ = 0;
  steps_ = 0;
  deepest_ = 0;
  phases_.Clear();
  particles_.Clear();
  InitialPositions();
  StepBackwards(0);
}

void ParticleSystem::Step() {
  if (trouble_) return;
  ComputeAccelerations();
  Integrate();
}

/// v(t - dt/2) from v(t) by half an Euler step backwards (paper, IV-B), for the particles from `first_id` on.
void ParticleSystem::StepBackwards(std::uint32_t first_id) {
  ComputeAccelerations();  // in any case: a view may want the fields before the next step
  if (parameters.integration == Integration::kSymplecticEuler) return;
  const double half = 0.5 * parameters.time_step;
  // The second-order form has its damping in Integrate, not in the acceleration.
  const double nu = parameters.integration == Integration::kLeapFrog ? parameters.motion_damping : 0.0;
  for (std::size_t i = 0; i < particles_.Size(); ++i) {
    if (particles_.id[i] < first_id) continue;
    particles_.vx_prev[i] = particles_.vx[i] - half * (particles_.ax[i] - nu * particles_.vx[i]);
    particles_.vy_prev[i] = particles_.vy[i] - half * (particles_.ay[i] - nu * particles_.vy[i]);
  }
}

void ParticleSystem::InitialPositions() {
  Random random(parameters.seed);
  for (const Vec2 place : Place(parameters.fluid, random)) {
    particles_.Add(place, parameters.fluid.velocity, parameters.particle_mass);
  }
}

std::string ParticleSystem::DropBlock() {
  if (trouble_) return "the simulation has broken down: reset it first";
  const Block& drop = parameters.drop;
  if (drop.particles == 0) return "this scene has no block to drop";
  if (particles_.Size() + drop.particles > parameters.particle_limit) {
    return fmt::format("particle limit of {} reached: a block of {} more does not fit (raise particle_limit)",
                       parameters.particle_limit, drop.particles);
  }
  const double free_distance = 0.9 * Spacing(drop);
  const Box bounds = drop.region.Bounds();
  Box room = LegalRegion(parameters.walls);
  if (!std::isfinite(room.y1)) room.y1 = bounds.y1 + 2 * bounds.Height();
  if (!std::isfinite(room.x0)) room.x0 = bounds.x0;
  if (!std::isfinite(room.x1)) room.x1 = bounds.x1;
  const auto occupied = [&](Vec2 site) {
    for (const Wall& wall : parameters.walls) {
      if (wall.Depth(site) > 0) return true;
    }
    for (std::size_t i = 0; i < particles_.Size(); ++i) {
      if (Length(particles_.Position(i) - site) < free_distance) return true;
    }
    return false;
  };
  const std::vector<Vec2> places = PlaceAround(drop, room, occupied);
  if (places.empty()) return "no room for another block: wait until the last one has fallen";
  const auto first_id = static_cast<std::uint32_t>(particles_.Size());
  for (const Vec2 place : places) particles_.Add(place, drop.velocity, parameters.particle_mass);
  StepBackwards(first_id);
  return {};
}

void ParticleSystem::ComputeAccelerations() {
  std::fill(particles_.ax.begin(), particles_.ax.end(), 0.0);
  std::fill(particles_.ay.begin(), particles_.ay.end(), 0.0);
  AddGravity();
  AddMotionDamping();
}

void ParticleSystem::AddGravity() {
  Particles& p = particles_;
  const Vec2 gravity = parameters.gravity;
  const double lambda = parameters.central_force;
  if (lambda != 0) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      p.ax[i] += gravity.x - lambda * p.x[i];
      p.ay[i] += gravity.y - lambda * p.y[i];
    }
  } else if (gravity != Vec2{}) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      p.ax[i] += gravity.x;
      p.ay[i] += gravity.y;
    }
  }
}

void ParticleSystem::AddMotionDamping() {
  // The second-order leapfrog takes the damping into its own step (see Integrate), where it costs nothing and does not
  // lag.
  const double nu = parameters.motion_damping;
  if (nu == 0 || parameters.integration == Integration::kLeapFrog) return;
  Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    p.ax[i] -= nu * p.vx[i];
    p.ay[i] -= nu * p.vy[i];
  }
}

void ParticleSystem::Boundaries(std::size_t i) {
  Particles& p = particles_;
  const double dt = parameters.time_step;
  double damping = 0;  // [1/s], of all the walls that the particle is in
  for (const Wall& wall : parameters.walls) {
    const double depth = wall.Depth(p.Position(i));
    if (depth <= 0) continue;
    deepest_ = std::max(deepest_, depth);
    const Vec2 push = parameters.wall.stiffness * depth * wall.Normal();
    const double speed = wall.velocity * parameters.wall.damping;  // damping is relative to the wall
    p.ax[i] += push.x + (wall.Vertical() ? speed : 0.0);
    p.ay[i] += push.y + (wall.Vertical() ? 0.0 : speed);
    damping += parameters.wall.damping;
  }
  if (damping == 0) return;
  if (parameters.integration != Integration::kLeapFrog) {
    p.ax[i] -= damping * p.vx[i];
    p.ay[i] -= damping * p.vy[i];
    return;
  }
  // Integrate knows the motion damping nu only. This is the acceleration with which its step comes out as the step of
  // the second-order form with nu + damping: v+ = [v- (1 - n dt/2) + a dt]/(1 + n dt/2), n = nu + damping.
  const double with_nu = 1 + 0.5 * parameters.motion_damping * dt;
  const double share = with_nu / (with_nu + 0.5 * damping * dt);
  const auto damped = [&](double a, double v_prev) {
    const double undamped_rest = v_prev * (2 - with_nu);  // v- (1 - nu dt/2)
    return (share * (undamped_rest - 0.5 * damping * dt * v_prev + a * dt) - undamped_rest) / dt;
  };
  p.ax[i] = damped(p.ax[i], p.vx_prev[i]);
  p.ay[i] = damped(p.ay[i], p.vy_prev[i]);
}

void ParticleSystem::AddWallForces() {
  if (parameters.walls.empty() || parameters.wall.kind != WallKind::kPenalty) return;
  const PhaseTimer timer(phases_, "walls");
  const Box legal = LegalRegion(parameters.walls);
  for (std::size_t i = 0; i < particles_.Size(); ++i) {
    const double x = particles_.x[i];
    const double y = particles_.y[i];
    if (x < legal.x0 || x > legal.x1 || y < legal.y0 || y > legal.y1) Boundaries(i);
  }
}

/// Leapfrog, eqs. 13-15, and the walls.
void ParticleSystem::Integrate() {
  AddWallForces();
  {
    const PhaseTimer timer(phases_, "integrate");
    const double dt = parameters.time_step;
    const bool euler = parameters.integration == Integration::kSymplecticEuler;
    const bool second_order = parameters.integration == Integration::kLeapFrog;
    // v+ = [v- (1 - nu dt/2) + a dt]/(1 + nu dt/2); the other forms have their damping in the acceleration already.
    const double half_damping = second_order ? 0.5 * parameters.motion_damping * dt : 0.0;
    const double keep = (1 - half_damping) / (1 + half_damping);
    const double gain = dt / (1 + half_damping);
    // The velocity kept beside the half steps: v(t + dt) extrapolated to second order; as published, eq. 15's v(t).
    const double of_new = euler ? 1.0 : second_order ? 1.5 : 0.5;
    const double of_old = euler ? 0.0 : second_order ? -0.5 : 0.5;
    const double longest = LongestMove() / dt;
    const double fastest_allowed = longest * longest;
    Particles& p = particles_;
    int broken = 0;
    const std::size_t n = p.Size();
#pragma omp parallel for schedule(static) num_threads(ThreadCount()) reduction(| : broken) if (n > 10000)
    for (std::size_t i = 0; i < n; ++i) {
      const double ux = keep * p.vx_prev[i] + gain * p.ax[i];
      const double uy = keep * p.vy_prev[i] + gain * p.ay[i];
      p.x[i] += ux * dt;
      p.y[i] += uy * dt;
      p.vx[i] = of_new * ux + of_old * p.vx_prev[i];
      p.vy[i] = of_new * uy + of_old * p.vy_prev[i];
      p.vx_prev[i] = ux;
      p.vy_prev[i] = uy;
      broken |= static_cast<int>(!(ux * ux + uy * uy <= fastest_allowed));  // true for a NaN, too
    }
    MoveWalls(parameters.walls, dt);
    time_ += dt;
    ++steps_;
    if (broken != 0) ReportTrouble();
  }
  ReflectFromWalls();
}

void ParticleSystem::ReflectFromWalls() {
  if (parameters.walls.empty() || parameters.wall.kind != WallKind::kReflect) return;
  const PhaseTimer timer(phases_, "walls");
  Particles& p = particles_;
  const double restitution = parameters.wall.restitution;
  for (const Wall& wall : parameters.walls) {
    auto& position = wall.Vertical() ? p.x : p.y;
    auto& velocity = wall.Vertical() ? p.vx : p.vy;
    auto& previous = wall.Vertical() ? p.vx_prev : p.vy_prev;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      if (wall.Depth(p.Position(i)) <= 0) continue;
      position[i] = wall.at;
      for (double* v : {&velocity[i], &previous[i]}) *v = wall.velocity - restitution * (*v - wall.velocity);
    }
  }
}

void ParticleSystem::ReportTrouble() {
  const Particles& p = particles_;
  const double longest = LongestMove();
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double moved = std::hypot(p.vx_prev[i], p.vy_prev[i]) * parameters.time_step;
    if (!(moved <= longest) && (!first || p.id[i] < p.id[*first])) first = i;
  }
  if (!first) return;
  const Vec2 velocity{p.vx_prev[*first], p.vy_prev[*first]};
  const double speed = Length(velocity);
  const std::string limit =
      std::isfinite(speed)
          ? fmt::format(
                "it moved further in the step than the support radius of {:.3g} m; the step was {:.3g} s, and only "
                "one below {:.3g} s would have held it",
                longest, parameters.time_step, longest / speed)
          : fmt::format("its velocity is not a number; the step of {:.3g} s is too long for the forces of this scene",
                        parameters.time_step);
  trouble_ = Instability{steps_, time_, p.id[*first], p.Position(*first), velocity, limit};
}

void ParticleSystem::Draw(Canvas& canvas) const {
  const Particles& p = particles_;
  std::vector<double> speed;
  std::span<const double> values;
  switch (canvas.WantedColouring()) {
    case Colouring::kBlackDisks:
      break;
    case Colouring::kSpeed:
      speed.resize(p.Size());
      for (std::size_t i = 0; i < p.Size(); ++i) speed[i] = Length(p.Velocity(i));
      values = speed;
      break;
    case Colouring::kPressure:
      values = Pressure();
      break;
    case Colouring::kDensity:
      values = Density();
      break;
  }
  constexpr double kRadiusInSpacings = 0.35;  // disks stay apart where the fluid is at rest
  canvas.DrawDisks(p.x, p.y, kRadiusInSpacings * InitialSpacing(), values);
  constexpr double kFar = 1e6;
  const Box view{-kFar, -kFar, kFar, kFar};
  for (const Wall& wall : parameters.walls) {
    if (const auto segment = VisibleSegment(wall, parameters.walls, view)) canvas.DrawWall(segment->a, segment->b);
  }
}

double ParticleSystem::LongestMove() const { return std::numeric_limits<double>::max(); }

int ParticleSystem::ThreadCount() const { return parameters.threads > 0 ? parameters.threads : omp_get_num_procs(); }

std::vector<PassPlan> ParticleSystem::Plan() const {
  const Parameters& p = parameters;
  const bool forces = p.gravity != Vec2{} || p.central_force != 0;
  const bool walls = !p.walls.empty();
  return {
      {"gravity", forces, forces ? "body force on every particle" : "gravity and central force are 0"},
      {"motion damping", p.motion_damping != 0,
       p.motion_damping == 0                     ? "damping is 0"
       : p.integration == Integration::kLeapFrog ? "inside the leapfrog step"
                                                 : "added to the acceleration"},
      {"walls", walls, walls ? fmt::format("{} walls, particles behind one of them only", p.walls.size()) : "no walls"},
      {"integrate", true, "positions and velocities"},
  };
}

}  // namespace sph
