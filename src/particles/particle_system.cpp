#include "particles/particle_system.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"

namespace sph {

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
  previous_step_ = parameters.time_step;
  deepest_ = last_travel_ = 0;
  phases_.Clear();
  particles_.Clear();
  notes_.clear();
  InitialPositions();
  ForgetNeighbours();
  auto breach = FindBrokenStart();
  if (!breach) {
    StepBackwards(0);
    breach = FindBrokenForces();
  }
  if (breach) StopAt(*breach);
}

void ParticleSystem::Step() {
  if (trouble_) return;
  ComputeAccelerations();
  if (parameters.adaptive_step) ChooseStep();
  if (!trouble_) Integrate();
}

void ParticleSystem::ComputeFields() {
  if (trouble_) return;
  ComputeAccelerations();
  if (const auto breach = FindBreach()) StopAt(*breach);
}

/// v(t - dt/2) from v(t) by half an Euler step backwards (paper, IV-B), for the particles from `first_id` on.
void ParticleSystem::StepBackwards(std::uint32_t first_id) {
  ComputeAccelerations();  // in any case: a view may want the fields before the next step
  if (parameters.integration == Integration::kSymplecticEuler) return;
  const double half = 0.5 * previous_step_;
  // The second-order form has its damping in Integrate, not in the acceleration.
  const double nu = parameters.integration == Integration::kLeapFrog ? parameters.motion_damping : 0.0;
  for (std::size_t i = 0; i < particles_.Size(); ++i) {
    if (particles_.id[i] < first_id) continue;
    particles_.vx_prev[i] = particles_.vx[i] - half * (particles_.ax[i] - nu * particles_.vx[i]);
    particles_.vy_prev[i] = particles_.vy[i] - half * (particles_.ay[i] - nu * particles_.vy[i]);
  }
}

void ParticleSystem::InitialPositions() {
  if (parameters.given != nullptr) {
    particles_ = parameters.given->particles;
    particles_.vx_prev = particles_.vx;
    particles_.vy_prev = particles_.vy;
    for (std::size_t i = 0; i < particles_.Size(); ++i) particles_.id[i] = static_cast<std::uint32_t>(i);
    return;
  }
  particles_.Reserve(parameters.start.size());
  for (const StartingParticle& particle : parameters.start) {
    particles_.Add(particle.position, parameters.fluid.velocity, particle.mass);
  }
  if (!parameters.start.empty()) return;
  Random random(parameters.seed);
  const std::vector<Vec2> places = Place(parameters.fluid, random);
  particles_.Reserve(places.size());
  for (const Vec2 place : places) {
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
  std::vector<std::byte> before;
  Archive writer = Archive::Writer(before, Archive::Extent::kPhysics);
  Transfer(writer);
  const auto first_id = static_cast<std::uint32_t>(particles_.Size());
  for (const Vec2 place : places) particles_.Add(place, drop.velocity, parameters.particle_mass);
  notes_.clear();
  ForgetNeighbours();
  auto breach = FindBrokenStart();
  if (!breach) {
    StepBackwards(first_id);
    breach = FindBrokenForces();
  }
  if (!breach) return {};
  Archive reader = Archive::Reader(before, Archive::Extent::kPhysics);
  Transfer(reader);
  return "no block is dropped, because it would break everything down: of a particle, " + breach->limit;
}

void ParticleSystem::ComputeAccelerations() {
  ClearAccelerations(0, particles_.Size());
  AddGravity(0, particles_.Size());
  AddMotionDamping(0, particles_.Size());
}

void ParticleSystem::ClearAccelerations(std::size_t first, std::size_t last) {
  std::fill(particles_.ax.data() + first, particles_.ax.data() + last, 0.0);
  std::fill(particles_.ay.data() + first, particles_.ay.data() + last, 0.0);
}

void ParticleSystem::AddGravity(std::size_t first, std::size_t last) {
  Particles& p = particles_;
  const Vec2 gravity = parameters.gravity;
  const double lambda = parameters.central_force;
  if (lambda != 0) {
    for (std::size_t i = first; i < last; ++i) {
      p.ax[i] += gravity.x - lambda * p.x[i];
      p.ay[i] += gravity.y - lambda * p.y[i];
    }
  } else if (gravity != Vec2{}) {
    for (std::size_t i = first; i < last; ++i) {
      p.ax[i] += gravity.x;
      p.ay[i] += gravity.y;
    }
  }
}

void ParticleSystem::AddMotionDamping(std::size_t first, std::size_t last) {
  // The second-order leapfrog takes the damping into its own step (see Integrate), where it costs nothing and does not
  // lag.
  const double nu = parameters.motion_damping;
  if (nu == 0 || parameters.integration == Integration::kLeapFrog) return;
  Particles& p = particles_;
  for (std::size_t i = first; i < last; ++i) {
    p.ax[i] -= nu * p.vx[i];
    p.ay[i] -= nu * p.vy[i];
  }
}

/// The largest step that the limits allow, but not much longer than the last one: an estimate from one state must not
/// run ahead of what the next states turn out to be.
void ParticleSystem::ChooseStep() {
  constexpr double kLargestGrowth = 1.1;
  constexpr double kHopeless = 1e-6;  // of the scene's step: a run that would never come to its end
  const std::vector<StepLimit> limits = StepLimits();
  const double largest = parameters.caution * LargestStep(limits);
  if (!(largest > kHopeless * initial_parameters_.time_step)) {
    const auto closest = std::ranges::min_element(limits, {}, &StepLimit::seconds);
    if (particles_.Size() > 0) {
      StopAt({FastestParticle(), fmt::format("the step may be {:.2g} s at most, which is below a millionth of the "
                                             "scene's {:.2g} s: {}",
                                             largest, initial_parameters_.time_step, closest->what)});
      return;
    }
  }
  parameters.time_step =
      steps_ == 0 ? std::min(largest, parameters.time_step) : std::min(largest, kLargestGrowth * previous_step_);
}

/// The one that moves fastest, or that forces push most where all are slow.
std::size_t ParticleSystem::FastestParticle() const {
  const Particles& p = particles_;
  std::size_t fastest = 0;
  double most = -1;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double speed =
        std::hypot(p.vx_prev[i], p.vy_prev[i]) + initial_parameters_.time_step * std::hypot(p.ax[i], p.ay[i]);
    if (!std::isfinite(speed)) return i;
    if (speed > most) fastest = i;
    most = std::max(most, speed);
  }
  return fastest;
}

std::vector<StepLimit> ParticleSystem::StepLimits() const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Parameters& p = parameters;
  const bool penalty = !p.walls.empty() && p.wall.kind == WallKind::kPenalty && p.wall.stiffness > 0;
  return {
      {"wall stiffness", penalty ? 2 / std::sqrt(p.wall.stiffness) : kNone},
      {"central force", p.central_force > 0 ? 2 / std::sqrt(p.central_force) : kNone},
  };
}

void ParticleSystem::Transfer(Archive& archive) {
  archive(time_, steps_, previous_step_, deepest_);
  archive(parameters.time_step, parameters.caution);
  std::uint64_t walls = parameters.walls.size();
  archive(walls);
  Archive::Require(walls == parameters.walls.size());
  for (Wall& wall : parameters.walls) archive(wall.at, wall.velocity, wall.lowest, wall.highest);
  particles_.Transfer(archive);
  if (!archive.Reading()) return;
  trouble_.reset();
  notes_.clear();
}

/// Leapfrog, eqs. 13-15, and the walls.
void ParticleSystem::Integrate() {
  AddWallForces();
  {
    const PhaseTimer timer(phases_, "integrate");
    const double dt = parameters.time_step;
    MoveWalls(parameters.walls, dt);
    legal_ = LegalRegion(parameters.walls);
    notes_.resize(ChunkCount());
    ForEachChunk([&](std::size_t chunk, std::size_t first, std::size_t last) { notes_[chunk] = Advance(first, last); });
    double fastest2 = 0;  // [m^2/s^2]
    bool finite = true;
    for (const ChunkNotes& notes : notes_) {
      fastest2 = std::max(fastest2, notes.fastest2);
      finite = finite && std::isfinite(notes.fastest2);
    }
    previous_step_ = dt;
    last_travel_ = std::sqrt(fastest2) * dt;
    time_ += dt;
    ++steps_;
    const bool in_order = finite && last_travel_ <= LongestMove();
    if (const auto breach = in_order ? FindBreach() : FindMoveTooFar()) {
      StopAt(*breach);
    }
  }
  ReflectFromWalls();
  AfterStep();
}

/// One leapfrog step of the particles first ... last - 1.
ParticleSystem::ChunkNotes ParticleSystem::Advance(std::size_t first, std::size_t last) {
  const double dt = parameters.time_step;
  const double before = 0.5 * previous_step_;
  const double after = 0.5 * dt;
  const bool euler = parameters.integration == Integration::kSymplecticEuler;
  const bool second_order = parameters.integration == Integration::kLeapFrog;
  // v+ = [v- (1 - nu before) + a (before + after)]/(1 + nu after); with equal steps both are dt/2. The other forms have
  // their damping in the acceleration already.
  const double nu = second_order ? parameters.motion_damping : 0.0;
  const double keep = (1 - nu * before) / (1 + nu * after);
  const double gain = (before + after) / (1 + nu * after);
  // The velocity kept beside the half steps: v(t + dt) extrapolated to second order; as published, eq. 15's v(t).
  const double ahead = after / (before + after);
  const double of_new = euler ? 1.0 : second_order ? 1 + ahead : 0.5;
  const double of_old = euler ? 0.0 : second_order ? -ahead : 0.5;
  const Box legal = legal_;
  double* const x = particles_.x.data();
  double* const y = particles_.y.data();
  double* const vx = particles_.vx.data();
  double* const vy = particles_.vy.data();
  double* const vx_prev = particles_.vx_prev.data();
  double* const vy_prev = particles_.vy_prev.data();
  const double* const ax = particles_.ax.data();
  const double* const ay = particles_.ay.data();
  double fastest2 = 0;
  double sum2 = 0;  // not a number if one of the speeds or places is not, which a maximum may hide
  double outside = 0;
#pragma omp simd reduction(max : fastest2) reduction(+ : sum2, outside)
  for (std::size_t i = first; i < last; ++i) {
    const double ux = keep * vx_prev[i] + gain * ax[i];
    const double uy = keep * vy_prev[i] + gain * ay[i];
    const double new_x = x[i] + ux * dt;
    const double new_y = y[i] + uy * dt;
    x[i] = new_x;
    y[i] = new_y;
    vx[i] = of_new * ux + of_old * vx_prev[i];
    vy[i] = of_new * uy + of_old * vy_prev[i];
    vx_prev[i] = ux;
    vy_prev[i] = uy;
    const double speed2 = ux * ux + uy * uy;
    fastest2 = std::max(fastest2, speed2);
    sum2 += speed2 + (new_x * new_x + new_y * new_y);
    const double beyond_x = std::max(legal.x0 - new_x, new_x - legal.x1);
    const double beyond_y = std::max(legal.y0 - new_y, new_y - legal.y1);
    outside += std::max(beyond_x, beyond_y) > 0 ? 1.0 : 0.0;
  }
  const bool behind_wall = outside > 0;
  if (behind_wall && second_order && parameters.wall.kind == WallKind::kPenalty) CatchAtWalls(first, last);
  return {.fastest2 = std::isfinite(sum2) ? fastest2 : sum2, .behind_wall = behind_wall};
}

double ParticleSystem::LongestMove() const { return std::numeric_limits<double>::max(); }

int ParticleSystem::ThreadCount() const { return parameters.threads > 0 ? parameters.threads : omp_get_num_procs(); }

namespace {

std::string AboutWalls(const Parameters& p) {
  const auto sticking = std::ranges::count_if(p.walls, [&](const Wall& wall) { return Sticks(wall, p.wall); });
  const std::string sticks = sticking > 0 ? fmt::format("; the fluid sticks to {} of them", sticking) : "";
  if (p.wall.kind == WallKind::kParticles) {
    return fmt::format("particles behind {} walls, in both passes{}", p.walls.size(), sticks);
  }
  return fmt::format("{} walls, particles behind one of them only{}", p.walls.size(), sticks);
}

}  // namespace

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
      {"walls", walls, walls ? AboutWalls(p) : "no walls"},
      {"integrate", true, "positions and velocities"},
  };
}

}  // namespace sph
