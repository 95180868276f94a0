// A scene as data: what a scene file says, in the types that a particle system takes.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "particles/parameters.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// Moves a wall at once to its place [m].
struct MoveWallAction {
  std::string wall;
  double to = 0;
};

/// Sets a scene key that may change while the scene runs.
struct SetAction {
  std::string key;
  double to = 0;
};

/// What a key does in one scene only.
struct SceneControl {
  std::string press;  ///< the key's name
  std::string what;   ///< one line for the help screen
  std::vector<std::variant<MoveWallAction, SetAction>> actions;
};

/// How wall stiffness and damping follow the resolution.
enum class WallScaling {
  kDerived,    ///< K in proportion to N, damping to sqrt(N): the penetration stays the same part of a spacing
  kPublished,  ///< constant, as in the paper: the penetration in spacings grows in proportion to N
};

/// The exact solution that a scene is compared with.
enum class Reference { kNone, kStaticStar };

/// M and R of a toy star, from which its central force follows (paper, Table I).
struct StarForce {
  double mass = 0;    ///< [kg/m]
  double radius = 0;  ///< [m]
};

/// Before the start the fluid comes to rest under its forces, if this is asked for.
struct Settling {
  double time = 0;     ///< [s]
  double damping = 0;  ///< [1/s]
};

/// Of a scene, with and without --particles.
inline constexpr std::size_t kMostParticles = 100'000'000;

struct Scene {
  std::string name;                   ///< the file's name without its ending
  std::vector<std::string> warnings;  ///< of names that are old, each with its place
  std::string title;
  std::string about;  ///< a few lines for people
  std::string solver = "paper";
  int retries = 3;    ///< how often a step that breaks down is undone and halved, see Guard
  double until = 10;  ///< where `run` and `render` end if not told [s]
  Box view;           ///< what the window shows at first [m]; empty: walls and fluid with a margin

  Parameters base;
  ParametersSPH sph;
  std::optional<StarForce> star;
  Settling settling;
  WallScaling wall_scaling = WallScaling::kDerived;
  Reference reference = Reference::kNone;

  std::string arrow_wall;  ///< the wall that Left and Right move; none if empty
  double arrow_speed = 0;  ///< [m/s]
  std::vector<SceneControl> controls;
};

}  // namespace sph
