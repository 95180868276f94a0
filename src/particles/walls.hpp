// Rigid plane walls (paper, IV-D): where they are, how deep a particle is inside one, how they move.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec2.hpp"

namespace sph {

/// On which side of a wall the fluid is.
enum class FluidSide { kLeft, kRight, kBelow, kAbove };

/// v(t) = mean + amplitude sin(2 pi frequency t + phase).
struct TangentialVelocity {
  double mean = 0;       ///< [m/s], to the right or upwards
  double amplitude = 0;  ///< [m/s]
  double frequency = 0;  ///< [Hz]
  double phase = 0;      ///< [rad]

  double At(double time) const;
  bool Any() const { return mean != 0 || amplitude != 0; }
};

/// The half-plane behind a vertical or horizontal line. It moves with `velocity` until it reaches an end of its range.
struct Wall {
  std::string name;
  FluidSide fluid = FluidSide::kAbove;
  double at = 0;        ///< x of a vertical wall, y of a horizontal one [m]
  double velocity = 0;  ///< d(at)/dt [m/s]
  double lowest = 0;    ///< range of `at` [m]; a wall that cannot be moved has lowest = highest = at
  double highest = 0;
  TangentialVelocity tangential = {};  ///< along itself, of a wall to which the fluid sticks
  std::optional<bool> no_slip = {};    ///< unless it is as WallParameters say

  bool Vertical() const { return fluid == FluidSide::kLeft || fluid == FluidSide::kRight; }
  /// Unit vector from the wall into the fluid.
  Vec2 Normal() const;
  /// How far a point is inside the wall [m]; negative in the fluid.
  double Depth(Vec2 point) const;
};

/// What happens to a particle inside a wall.
enum class WallKind {
  kPenalty,  ///< pushed back in proportion to its depth, and damped (paper, IV-D)
  kMirror,   ///< the fluid sees itself behind the wall, and particles that get there come to rest on it
  kReflect,  ///< put back on the wall, the normal velocity multiplied by -restitution (tutorial)
  /// Particles stand behind the wall, with pressures and velocities from the fluid near them [S. Adami, X. Y. Hu & N.
  /// A. Adams, J. Comput. Phys. 231 (2012) 7057], and particles of the fluid that get there come to rest on it.
  kParticles,
};

struct WallParameters {
  WallKind kind = WallKind::kPenalty;
  double stiffness = 0;    ///< K [1/s^2]: a = K depth, along the normal
  double damping = 0;      ///< [1/s]: a -= damping (v - v_wall)
  double restitution = 0;  ///< speed after a reflection over the speed before
  bool no_slip = false;    ///< of walls that the fluid sees and that do not say: it sticks to them
  /// Of such walls along which the fluid slips: the kinematic viscosity [m^2/s] of the turbulent boundary layer that
  /// brakes it, too thin to be seen by the particles; 0: there is none.
  double layer_viscosity = 0;

  /// Whether there is something behind the wall for the passes over neighbours.
  bool SeenByFluid() const { return kind == WallKind::kMirror || kind == WallKind::kParticles; }
};

/// Whether the fluid sticks to the wall.
bool Sticks(const Wall& wall, const WallParameters& parameters);

/// Depth [m] and speed into the wall [m/s] of a particle relative to it.
struct Penetration {
  double depth = 0;
  double speed = 0;
};

/// What a penalty wall makes of a particle that went in at `speed`, `seconds` later: the solution of d'' = -K d - c d'
/// with d = 0 and d' = speed at the start, K and c being the wall's stiffness and damping.
Penetration PenetrationAfter(const WallParameters& wall, double speed, double seconds);

/// Moves every wall by its velocity times dt; one that reaches an end of its range stops there.
void MoveWalls(std::span<Wall> walls, double dt);

/// Of each side of the fluid the wall that bounds it; nullptr where none does.
class BoundingWalls {
 public:
  /// As the walls are, or were so long ago [s]. Of two in one place the one that comes faster towards the fluid bounds
  /// it, and then the first by name: their order does not matter.
  explicit BoundingWalls(std::span<const Wall> walls, double seconds_ago = 0);

  const Wall* Of(FluidSide fluid) const { return all_[static_cast<std::size_t>(fluid)]; }
  /// In the order of FluidSide.
  std::array<const Wall*, 4> All() const { return all_; }

 private:
  std::array<const Wall*, 4> all_{};
};

/// The part of the plane that no wall covers, or covered so long ago [s]; infinite where there is no wall.
Box LegalRegion(std::span<const Wall> walls, double seconds_ago = 0);

/// The wall with that name, or nullptr.
Wall* FindWall(std::span<Wall> walls, std::string_view name);

/// The piece of a wall that bounds the legal region, to be drawn: its ends [m], cut off at `view` where no wall ends
/// it. Empty when other walls cover it.
struct Segment {
  Vec2 a;
  Vec2 b;
};
std::optional<Segment> VisibleSegment(const Wall& wall, std::span<const Wall> walls, const Box& view);

}  // namespace sph
