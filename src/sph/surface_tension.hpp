// The tension of a free surface: the pressure that it lays on the fluid, in proportion to its curvature.
#pragma once

#include <array>
#include <vector>

#include "sph/delta_passes.hpp"

namespace sph {

/// Of all particles and images. C, the colour, is the share of its support that fluid fills, weighted with Poly6; it
/// falls from 1 to 1/2 where the fluid ends, within a support radius.
template <typename Real>
struct SurfaceArrays {
  std::vector<Real> normal_x, normal_y;  ///< grad C/|grad C|, pointing inwards
  /// s: 1 near a surface, 0 inside, where grad C is the particles' unevenness and no more.
  std::vector<Real> part;
  std::vector<Real> weight;  ///< s V [m^2]
  std::vector<Real> depth;   ///< of the particle below the surface, as C tells it [m]

  std::array<std::vector<Real>*, 5> All() { return {&normal_x, &normal_y, &part, &weight, &depth}; }
};

/// What the pass of the force reads, of all particles and images.
template <typename Real>
struct SurfaceInput {
  SmoothingKernel kernel = SmoothingKernel::kWendlandC2;  ///< of the pressure force
  const SurfaceArrays<Real>* arrays = nullptr;
  const Real* volume = nullptr;   ///< m/rho [m^2]
  const Real* density = nullptr;  ///< [kg/m^3]
  double tension = 0;             ///< sigma [N]
};

/// The longest step for which leapfrog follows the shortest waves of the surface, sqrt(rho h^3/(2 pi sigma))/4 [J. P.
/// Morris, Int. J. Numer. Methods Fluids 33 (2000) 333, after Brackbill et al. 1992, eq. 61], h being half the support
/// [s].
double LongestTensionStep(double support, double density, double tension);

/// Computes the arrays of the block's particles; volume = m/rho [m^2].
template <typename Real>
void ComputeSurface(const PassInput<Real>& input, const Real* volume, const ListBlock& block,
                    SurfaceArrays<Real>& arrays);

/// Adds 2 s sigma kappa/(f rho_i) sum_j V_j grad W [m/s^2] to the accelerations of the block's particles, f being the
/// part of the gradient at a flat surface that s leaves. Without it the pressure force of solver delta is that of a
/// fluid with no pressure outside; with it the pressure outside is s sigma kappa/f, so that a drop with the pressure
/// sigma kappa throughout is nearly at rest. It is the continuum surface force [J. U. Brackbill, D. B. Kothe & C.
/// Zemach, J. Comput. Phys. 100 (1992) 335] in the discrete form of the pressure's.
/// kappa = k/(1 + k depth) is the surface's curvature next to the particle, k = -div n the one of the parallel line
/// through it; the divergence is renormalised with those neighbours that have normals.
template <typename Real>
void AddSurfaceTension(const PassInput<Real>& input, const SurfaceInput<Real>& surface, const ListBlock& block,
                       double* ax, double* ay);

}  // namespace sph
