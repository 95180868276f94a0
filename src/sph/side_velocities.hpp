// What velocity the fluid behind a wall has that stands for the wall: of mirror images and of wall particles.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "neighbours/wall_sites.hpp"
#include "particles/walls.hpp"

namespace sph {

/// What the walls that bound the fluid prescribe of its velocity in one pass.
class SideVelocities {
 public:
  /// That nothing goes through the walls, as they were so long ago [s]. The flow behind a wall then is the mirror image
  /// of that before it, and as free of divergence; with the velocity along the wall turned round as well, it would have
  /// a divergence of 2 du/dx there [M. De Leffe, D. Le Touze & B. Alessandrini, Proc. 6th SPHERIC
  /// Workshop (2011)].
  static SideVelocities ForDensity(std::span<const Wall> walls, double seconds_ago);
  /// Also the velocities at this time [s] of walls along themselves, where the fluid sticks to them
  /// [H. Takeda, S. M. Miyama & M. Sekiya, Prog. Theor. Phys. 92 (1994) 939].
  static SideVelocities ForForces(std::span<const Wall> walls, const WallParameters& parameters, double time);

  /// The velocity [m/s] behind walls of what has velocity v before them: 2 v_wall - v in what a wall prescribes, v in
  /// what none does. Where two walls prescribe the same component, a and b, turning it round at one and then at the
  /// other gives v + 2 (b - a) or v - 2 (b - a); their mean is v.
  Vec2 Behind(Vec2 velocity, Beyond in_x, Beyond in_y) const;

 private:
  struct Side {
    std::optional<double> vx, vy;  // [m/s]
  };
  static Side NormalOf(const Wall* wall);

  std::array<Side, 4> sides_;  // in the order of FluidSide
};

}  // namespace sph
