// Small waves on an endless square lattice of equal particles at rest, and the longest step that leapfrog takes them
// in.
#pragma once

#include <functional>

#include "base/vec2.hpp"

namespace sph {

/// A kernel of the smoothing length 1, by its derivatives along the radius.
struct RadialKernel {
  double support = 2;                            ///< in smoothing lengths
  std::function<double(double)> value = {};      ///< W(q)
  std::function<double(double)> slope = {};      ///< W'(q) of q > 0
  std::function<double(double)> curvature = {};  ///< W''(q)
};

RadialKernel CubicSplineOfUnitLength();
RadialKernel WendlandC2OfUnitLength();
RadialKernel WendlandC4OfUnitLength();
RadialKernel QuinticSplineOfUnitLength();
/// Mueller's, of which the smoothing length is the support.
RadialKernel Poly6OfUnitLength();
RadialKernel SpikyOfUnitLength();

struct LatticeWaves {
  double h_over_spacing = 1.3;
  /// P/(rho c^2) of the undisturbed fluid: 0 for a liquid at its reference density, 1/2 for a gas of P = k rho^2.
  double pressure = 0;
  /// Whether density is the sum over the kernel. On a lattice it differs a little from mass over cell.
  bool summed = false;
};

/// The greatest omega h/c of
///   M = V^2 (1 - 2 chi) S S^T + 2 V chi T,  S = sum grad W sin k.r,  T = sum grad grad W (1 - cos k.r),
/// over all wave vectors k, whose displacements u have omega^2 u = c^2 M(k) u; V is mass over density, chi the
/// pressure, the sums go over all r of the lattice. It follows from the summation density, or at chi = 0 from the
/// continuity equation, and the symmetric momentum equation a = -sum m (P_i/rho_i^2 + P_j/rho_j^2) grad W, linearised
/// [D. J. Price, J. Comput. Phys. 231 (2012) 759, eqs. 6, 30].
double GreatestFrequency(const RadialKernel& kernel, const LatticeWaves& waves);

/// The greatest growth rate times h/c of waves that grow (omega^2 < 0), because the lattice is none that the particles
/// would stay on: pairing where neighbours are many, other lattices where they are few. 0 if none grows.
double GreatestGrowth(const RadialKernel& kernel, const LatticeWaves& waves);

/// The same as GreatestFrequency for Mueller's solver at rest density without viscosity: M = V^2/2 S_pressure
/// S_density^T, half a gradient of pressure, because (P_i + P_j)/2 stands where the sum over the lattice needs P_i +
/// P_j.
double GreatestFrequency(const RadialKernel& density, const RadialKernel& pressure, double h_over_spacing);
double GreatestGrowth(const RadialKernel& density, const RadialKernel& pressure, double h_over_spacing);

/// Leapfrog holds omega dt < 2: the greatest stable c dt/h.
inline double StableStep(double greatest_frequency) { return 2 / greatest_frequency; }

}  // namespace sph
