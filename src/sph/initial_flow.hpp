// Flows that a scene can start with: velocity and pressure of an exact solution at t = 0.
#pragma once

#include <span>
#include <string>

#include "base/vec2.hpp"

namespace sph {

/// What a flow is scaled to.
struct FlowScale {
  Box box;             ///< of the fluid [m]
  double speed = 0;    ///< U [m/s]
  double density = 0;  ///< rho0 [kg/m^3]
  double mass = 0;     ///< of all the fluid [kg/m]
  Vec2 gravity;        ///< [m/s^2]
  double central = 0;  ///< lambda of a = -lambda x [1/s^2]
};

struct FlowAtPoint {
  Vec2 velocity;        ///< [m/s]
  double pressure = 0;  ///< of a liquid [Pa]
  double density = 0;   ///< of a gas [kg/m^3]
};

/// Gravity that a flow's pressure stands against, and that walls must hold the fluid against.
enum class Weight { kNone, kAnyWay, kDownwards };

struct InitialFlow {
  std::string name;
  std::string what;  ///< one line for people
  FlowAtPoint (*at)(Vec2 point, const FlowScale& scale);
  Weight weight = Weight::kNone;
};

/// Every flow, the one at rest first.
std::span<const InitialFlow> AllInitialFlows();

}  // namespace sph
