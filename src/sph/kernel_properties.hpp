// What is known of the kernels of solver delta, each constant from its formula or from waves on lattices.
#pragma once

#include "sph/delta_passes.hpp"

namespace sph {

/// Lengths are in support radii in `variance`, `flat` and `fall`; in the other constants in half support radii, as
/// which h counts there: it is h but for the quintic spline.
struct KernelProperties {
  const char* name;
  double variance;    ///< of W, of one coordinate
  double flat, fall;  ///< W'/r (flat - fall s^2), s = r/R, has the second moment of W'/r and no fourth one
  double water_step;  ///< greatest stable c dt: 2/max(K W(K)) of the kernel's Fourier transform
  double sharp_step;  ///< the same where the gradient of pressure has the weights flat - fall s^2
  double gas_step;    ///< the same for P = rho c^2/2
  double spread;      ///< 1/max(sum V (-W'/r)(1 - cos k.x)) on square lattices, least for spacings from 1/1.6 to 1/2.8
  double damped_sound;  ///< d/delta such that w^2 dt^2/4 + d dt/2 < 1 for sound on lattices that diffusion damps
  double sharp_damped;  ///< d/delta^2 such that this holds with weights flat - fall s^2, too
  double along_spread;  ///< 2/max of the greater eigenvalue of sum V (-W'/r) (r r^T/r^2)(1 - cos k.x): along pairs
};

const KernelProperties& PropertiesOf(SmoothingKernel kernel);

/// The mean over the square and the hexagonal lattice of sums that are 1 in a continuum: particles at rest or in motion
/// stand between these two.
struct LatticeSums {
  double concentration = 1;  ///< sum V W
  double second_order = 1;   ///< sum V (-W'/r) r^2/2
  double fourth_order = 1;   ///< the same times flat - fall s^2
};

/// @param reach  support radius over the spacing, > 0.
LatticeSums SumsOnLattices(SmoothingKernel kernel, double reach);

}  // namespace sph
