// The paper's Parameters[N_PARAMS], by name: everything that a particle system without pressure needs to know.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/vec2.hpp"
#include "particles/particles.hpp"
#include "particles/placement.hpp"
#include "particles/walls.hpp"

namespace sph {

/// How velocities and positions advance (paper, III).
enum class Integration {
  kLeapFrog,           ///< eqs. 13, 14; damping taken at t by averaging both half steps, solved exactly: second order
  kLeapFrogPublished,  ///< eqs. 13, 14 with eq. 15 as printed: the damping lags, first order
  kSymplecticEuler,    ///< v += a dt, then x += v dt (the tutorial's)
};

/// Where a particle starts.
struct StartingParticle {
  Vec2 position;    ///< [m]
  double mass = 0;  ///< [kg/m]
};

/// Particles to start with, as another run left them.
struct GivenStart {
  Particles particles;
  std::vector<double> density;  ///< [kg/m^3] of each; empty if nobody knows
};

struct Parameters {
  Block fluid;                                        ///< the start
  std::vector<StartingParticle> start;                ///< of particles that do not start as placed; empty: all do
  std::shared_ptr<const GivenStart> given = nullptr;  ///< if there, these are the start, with their velocities
  Block drop;                      ///< what DropBlock adds; its region is where the block appears if there is room
  double particle_mass = 0;        ///< [kg/m]
  std::uint64_t seed = 1;          ///< of the random start
  std::size_t particle_limit = 0;  ///< DropBlock refuses to go above this number

  double time_step = 0;        ///< [s]; the first one if the step is adaptive
  bool adaptive_step = false;  ///< each step the largest that the stability limits allow
  double caution = 1;          ///< an adaptive step is this part of that
  Integration integration = Integration::kLeapFrog;
  Vec2 gravity;               ///< [m/s^2]
  double central_force = 0;   ///< lambda [1/s^2]: a = -lambda x (paper, eq. 21)
  double motion_damping = 0;  ///< nu [1/s]: a = -nu v (paper, eq. 12)

  std::vector<Wall> walls;
  WallParameters wall;

  int threads = 0;  ///< 0: as many as there are processors
};

}  // namespace sph
