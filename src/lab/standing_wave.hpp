// The linear standing wave of a viscous fluid: how fast it swings and decays, exactly.
#pragma once

#include <complex>

#include "lab/series.hpp"

namespace sph {

/// A wave of wave number k [1/m] on a fluid of depth H [m] and kinematic viscosity nu [m^2/s] over a floor along which
/// it slips, under gravity g [m/s^2].
struct StandingWave {
  double k = 0, depth = 0, viscosity = 0, gravity = 0;

  /// s = -decay + i frequency [1/s] of the amplitude e^(st): the root of (m^2 + k^2)^2 + g k tanh(kH)/nu^2 - 4 k^3 m
  /// tanh(kH) coth(mH) = 0, m^2 = k^2 + s/nu, near that without viscosity. It comes from the linearised Navier-Stokes
  /// equations with a potential and a vortical part, cosh(ky) and cosh(my), and no stress at the surface; for great
  /// depths it is that of H. Lamb, Hydrodynamics, 1932, art. 349. Precondition: a viscosity > 0, with which the wave
  /// still swings.
  std::complex<double> Root() const;
  /// Velocity of the wave without viscosity, of size 1 at the surface [-]; x from a wall, y from the floor [m].
  Vec2 Shape(double x, double y) const;
};

/// Decay rate [1/s] and angular frequency [1/s] of a damped oscillation (time [s], deflection), as s above: from the
/// times at which it passes zero, and from how the areas between them become smaller, which noise hardly changes that
/// is less than how far the deflection goes from sample to sample there. Not a number if it passes zero less than four
/// times.
std::complex<double> FitDecay(const PointSeries& samples);

}  // namespace sph
