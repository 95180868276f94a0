// How the particles fill the plane: how high they stand, how densely, and whether they pair.
#pragma once

#include "base/vec2.hpp"
#include "particles/particles.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// What stands between two vertical walls, over a floor [m]. Its top is not looked at.
struct Trough {
  double left = 0, right = 0, floor = 0;
};

/// The area that the fluid fills over the trough's width [m]: the mean, over columns one spacing apart, of the height
/// at which, from above, sum_j V W reaches 1/2, as it is at the surface of a half-plane of fluid. V is the square of
/// `spacing`, not m/rho: a density that is wrong cannot hide what the particles do. W is a quintic spline of 1.5
/// spacings, whose sum over a lattice is 1 within 1e-4, and particles are seen reflected in walls and floor. So the
/// height of a lattice is exact within 1e-3 spacings.
double FilledHeight(const Particles& particles, const Trough& trough, double spacing);

/// The mean of sum_j m/rho0 W over the particles that are further than the support from all walls: 1 but for the
/// lattice's own sum where they fill the plane evenly. W is the Wendland kernel C2 of the solver's support.
double MeanConcentration(const ParticleSystemSPH& system);

/// The share of particles that have another within `distance` [m].
double PairedShare(const Particles& particles, double distance);

}  // namespace sph
