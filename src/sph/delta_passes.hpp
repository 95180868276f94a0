// The passes of the accurate solver over neighbours, on vectors: density and pressure for gas; rates of density and
// forces for water.
#pragma once

#include "sph/cluster_passes.hpp"
#include "sph/kernels.hpp"

namespace sph {

enum class SmoothingKernel { kWendlandC2, kWendlandC4, kQuintic };

/// Support radius over h.
inline double SupportOf(SmoothingKernel kernel) {
  return kernel == SmoothingKernel::kQuintic ? QuinticSpline::kSupport : WendlandC2::kSupport;
}

/// ComputeCubicSplineDensity and AddCubicSplinePressure with another kernel.
template <typename Real>
void ComputeGasDensity(SmoothingKernel kernel, const PassInput<Real>& input, ListBlock& block, Real* density);
template <typename Real>
void AddGasPressure(SmoothingKernel kernel, const PassInput<Real>& input, const ListBlock& block,
                    const Real* pressure_term, double* ax, double* ay);

/// What the passes for water read, of all particles and images.
template <typename Real>
struct WaterInput {
  SmoothingKernel kernel = SmoothingKernel::kWendlandC2;
  const Real* volume = nullptr;    ///< m/rho [m^2]
  const Real* excess = nullptr;    ///< rho - rho0 [kg/m^3]
  const Real* pressure = nullptr;  ///< [Pa]
  const Real* vx = nullptr;        ///< [m/s]
  const Real* vy = nullptr;
  const Real* gradient_x = nullptr;  ///< of density, renormalised [kg/m^4]
  const Real* gradient_y = nullptr;
  const Real* wholeness = nullptr;  ///< see WaterSums; of the step before
  double rho0 = 0;                  ///< [kg/m^3]
  double diffusion = 0;             ///< delta h c [m^2/s]
  double viscosity = 0;             ///< mu [Pa s]
  double artificial = 0;            ///< alpha h c rho0 [Pa s]
  double spacing = 0;               ///< [m]
  bool sharp_gradient = false;      ///< of pressure: weights of fourth order
  bool tensile_control = true;      ///< minus in the force below, for p_i < 0 away from a surface
};

/// drho_i/dt = rho_i sum_j V_j (u_i - u_j).grad W + delta h c sum_j V_j psi_ij.grad W,
/// psi_ij = 2 (rho_j - rho_i) r_ji/|r_ji|^2 - (grad rho_i + grad rho_j)
/// [Antuono et al., Comput. Phys. Commun. 181 (2010) 532; Marrone et al. 2011, eqs. 5 to 7] of the block's particles
/// [kg/(m^3 s)].
template <typename Real>
void ComputeDensityRates(const PassInput<Real>& input, const WaterInput<Real>& water, const ListBlock& block,
                         Real* rate);

/// What the force pass writes beside accelerations, of the block's particles.
template <typename Real>
struct WaterSums {
  Real* gradient_x =
      nullptr;  ///< of density, renormalised [kg/m^4]; 0 where the particle has neighbours on one side only
  Real* gradient_y = nullptr;
  Real* wholeness = nullptr;  ///< least eigenvalue of sum_j V_j (x_j - x_i) (x) grad W: 1 inside, 0 for a lone particle
  Real* shift_x = nullptr;    ///< sum_j V_j [1 + 0.2 (W/W(dx))^4] grad W, the part that the surface leaves [1/m]
  Real* shift_y = nullptr;
};

/// Adds to the accelerations [m/s^2] of the block's particles
///   -1/rho_i sum_j V_j (p_j +- p_i) grad W                                [minus: Sun et al. 2017, tensile control]
///   + 2 mu/rho_i sum_j V_j (u_j - u_i) (-W'/r)                            [Morris, Fox & Zhu 1997, eq. 22]
///   + alpha h c rho0/rho_i sum_j V_j (u_j - u_i).r_ji/|r_ji|^2 grad W     [Monaghan & Gingold 1983]
/// and computes `sums`. Lists that are coarse become shorter.
template <typename Real>
void AddWaterForces(const PassInput<Real>& input, const WaterInput<Real>& water, ListBlock& block, double* ax,
                    double* ay, const WaterSums<Real>& sums);

}  // namespace sph
