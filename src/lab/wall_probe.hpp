// A pressure gauge in a wall.
#pragma once

#include "base/vec2.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// The pressure at a point of a plane vertical wall [Pa]: sum_j V_j p_j W / sum_j V_j W over the particles and their
/// mirror images, with the solver's Wendland kernel round that point. No acceleration is normal to a wall that the
/// fluid slides along, so that dp/dn = 0 there and the fluid's pressures need no correction for their distance from it.
/// Where the particles around fill less than half of the kernel, what they lack of the half counts as air, of no
/// pressure: one drop is no full gauge. V_j = m/rho, p as of the last computed fields.
double PressureAtWall(const ParticleSystemSPH& system, Vec2 point);

}  // namespace sph
