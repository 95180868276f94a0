// The velocity at a point between particles.
#pragma once

#include "particles/particles.hpp"

namespace sph {

/// The value at `at` of the linear function that fits the velocities of the particles within `reach` [m] with the least
/// squares, weighted by the Wendland kernel C2: exact for what is linear, beside walls, too, behind which there are no
/// particles. Not a number with fewer than three particles off one line.
Vec2 VelocityAt(const Particles& particles, Vec2 at, double reach);

}  // namespace sph
