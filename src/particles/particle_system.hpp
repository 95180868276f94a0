// The paper's base class (IV): particles under gravity and damping, between walls, integrated by leapfrog.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/clock.hpp"
#include "base/random.hpp"
#include "base/shared_work.hpp"
#include "particles/canvas.hpp"
#include "particles/parameters.hpp"
#include "particles/particles.hpp"
#include "particles/step_limit.hpp"

namespace sph {

/// What went wrong when a step left the range in which the method holds.
struct Instability {
  long step = 0;
  double time = 0;       ///< [s]
  std::uint32_t id = 0;  ///< of the first particle concerned
  Vec2 position;         ///< its position [m] and velocity [m/s] after the step
  Vec2 velocity;
  std::string limit;   ///< the limit that was broken, in words, with its value
  std::string advice;  ///< what would have held; empty where nobody knows

  std::string Message() const;
};

/// What a step did not have to do, and why: one line of the plan that `sphlab info SCENE` prints.
struct PassPlan {
  std::string name;
  bool runs = false;
  std::string reason;
};

class ParticleSystem {
 public:
  explicit ParticleSystem(const Parameters& parameters);
  virtual ~ParticleSystem() = default;
  ParticleSystem(const ParticleSystem&) = delete;
  ParticleSystem& operator=(const ParticleSystem&) = delete;

  /// Back to the start: walls and parameters as constructed, InitialPositions(), and half an Euler step backwards for
  /// the velocities. To be called once before the first Step(), because a constructor cannot reach the virtual
  /// functions.
  void Reset();

  /// One time step. Once a step has broken down, Trouble() says how, and Step() does nothing more until Reset().
  void Step();

  /// Density, pressure and accelerations at the current time, for who wants to look at them after the last step; Step()
  /// itself computes them at its beginning. Does nothing once a step has broken down; may find that the last one has.
  void ComputeFields();

  /// Walls and particles, in the colouring that the canvas wants; of trouble, the particle that it began with.
  void Draw(Canvas& canvas) const;

  /// Adds parameters.drop on free sites at its region or above it.
  /// @return an empty string, or why nothing was added.
  std::string DropBlock();

  const std::optional<Instability>& Trouble() const { return trouble_; }
  /// Stops with this trouble. For who has put the system back to an earlier state, or knows what would have held.
  void StopWith(const Instability& trouble) { trouble_ = trouble; }
  double Time() const { return time_; }
  long Steps() const { return steps_; }
  const Particles& State() const { return particles_; }
  /// Deepest penetration of a wall by a particle so far [m].
  double DeepestPenetration() const { return deepest_; }
  const PhaseTimes& Phases() const { return phases_; }
  /// Side of the square that a particle of the initial block fills [m].
  double InitialSpacing() const { return Spacing(initial_parameters_.fluid); }
  /// What the view shows where no wall bounds it [m].
  Box InitialBounds() const { return initial_parameters_.fluid.region.Bounds(); }

  /// The passes of a step in their order, and those that this scene does not need.
  virtual std::vector<PassPlan> Plan() const;
  /// Sum over the particles of mass times specific internal energy [J/m]; 0 for particles without pressure.
  virtual double InternalEnergy() const { return 0; }
  /// Density [kg/m^3], pressure [Pa] of each particle, in State()'s order; empty where the system has none.
  virtual std::vector<double> Density() const { return {}; }
  virtual std::vector<double> Pressure() const { return {}; }

  /// Everything that the next steps depend on, but for the parameters that steps do not change. Read, it takes the
  /// place of what there was, trouble included; to be read into a system of the same scene.
  virtual void Transfer(Archive& archive);

  /// The limits on the time step in the present state; accelerations and density must be those of the current time.
  virtual std::vector<StepLimit> StepLimits() const;

  /// May be changed between steps.
  Parameters parameters;

 protected:
  /// The penalty force and damping of every wall that particle i is inside of (paper, IV-D).
  /// @return how deep it is [m]
  double Boundaries(std::size_t i);
  /// These two, and ClearAccelerations, act on the particles first ... last - 1.
  void AddGravity(std::size_t first, std::size_t last);
  void AddMotionDamping(std::size_t first, std::size_t last);
  void ClearAccelerations(std::size_t first, std::size_t last);
  virtual void ComputeAccelerations();
  virtual void InitialPositions();
  /// All parameters as they were constructed.
  virtual void RestoreParameters();
  /// Positions [m] as the canvas shall see them, x and y, where that is not as they are.
  virtual std::optional<std::pair<std::vector<double>, std::vector<double>>> ShownPositions() const {
    return std::nullopt;
  }
  /// A particle must not move further than this in a step [m].
  virtual double LongestMove() const;
  /// A particle and the limit that it has broken, in words.
  struct Breach {
    std::size_t particle = 0;
    std::string limit;
  };
  /// What else went wrong in a step whose moves were in order.
  virtual std::optional<Breach> FindBreach() const { return std::nullopt; }
  /// What no run can start with, before forces are looked at.
  virtual std::optional<Breach> FindBrokenStart() const;

  int ThreadCount() const;
  std::size_t ChunkCount() const { return (particles_.Size() + kParticlesPerChunk - 1) / kParticlesPerChunk; }
  /// Calls work(chunk, first, last) for the particles first ... last - 1 of every chunk, on all threads.
  template <typename Work>
  void ForEachChunk(Work work) const;
  /// How far the fastest particle went in the last step [m].
  double LastTravel() const { return last_travel_; }
  /// Puts the particles in another order, see Particles::Reorder.
  virtual void Reorder(std::span<const std::uint32_t> order) {
    particles_.Reorder(order, ThreadCount());
    if (std::ranges::any_of(notes_, &ChunkNotes::behind_wall)) notes_.clear();  // of the old order
  }
  /// Called when a step has moved the particles.
  virtual void AfterStep() {}
  /// Length of the last step [s]; before the first one, of that.
  double LastStep() const { return previous_step_; }
  /// Called when particles were added, removed or moved by other means than a step.
  virtual void ForgetNeighbours() {}

  Particles particles_;
  PhaseTimes phases_;

 private:
  /// The unit of work of the passes over single particles: small, so that few are looked through for those at walls.
  static constexpr std::size_t kParticlesPerChunk = 128;

  /// Of a chunk's particles after a step.
  struct ChunkNotes {
    double fastest2 = 0;  ///< square of the highest speed [m^2/s^2]; not a number if one of the speeds is not
    bool behind_wall = false;
    double deepest = 0;  ///< penetration when the walls were looked at [m]
  };

  void DrawTrouble(Canvas& canvas) const;
  void AddWallForces();
  void StopAt(const Breach& breach);
  std::size_t FastestParticle() const;
  void ChooseStep();
  void Integrate();
  ChunkNotes Advance(std::size_t first, std::size_t last);
  void CatchAtWalls(std::size_t first, std::size_t last);
  void ReflectFromWalls();
  void StepBackwards(std::uint32_t first_id);
  std::optional<Breach> FindMoveTooFar() const;
  std::optional<Breach> FindBrokenForces() const;

  Parameters initial_parameters_;
  std::optional<Instability> trouble_;
  double time_ = 0;
  long steps_ = 0;
  double deepest_ = 0;
  double previous_step_ = 0;  // [s], of the last step
  double last_travel_ = 0;
  std::vector<ChunkNotes> notes_;  // [chunks], of the last step, whose walls left legal_; empty if they do not hold
  Box legal_;
};

template <typename Work>
void ParticleSystem::ForEachChunk(Work work) const {
  constexpr std::size_t kChunksOfOneThread = 64;  // waking the others costs more than so little work
  const std::size_t n = particles_.Size();
  const std::size_t chunks = ChunkCount();
  ShareOut(chunks, chunks > kChunksOfOneThread ? ThreadCount() : 1, [&](std::size_t chunk) {
    const std::size_t first = chunk * kParticlesPerChunk;
    work(chunk, first, std::min(first + kParticlesPerChunk, n));
  });
}

}  // namespace sph
