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
  const Real* strain = nullptr;     ///< see DensitySums; of the same step
  double sound = 0;                 ///< c [m/s]
  double rho0 = 0;                  ///< [kg/m^3]
  double diffusion = 0;             ///< delta h c [m^2/s]
  double viscosity = 0;             ///< mu [Pa s]
  double artificial = 0;            ///< alpha h c rho0 [Pa s]
  double spacing = 0;               ///< [m]
  double variance = 0;              ///< of the kernel, of one coordinate [m^2]
  double gradient_flat = 1;         ///< the gradient of pressure has the weights grad W (flat - fall s^2), s = r/R:
  double gradient_fall = 0;         ///< of second order, or of fourth
  bool tensile_control = false;     ///< minus in the force below, for p_i < 0 away from a surface
};

/// What the pass of the densities writes, of the block's particles.
template <typename Real>
struct DensitySums {
  Real* rate = nullptr;  ///< of density [kg/(m^3 s)]
  /// S = sqrt(sum_j V_j (-W'/r) ((u_j - u_i).r_ji)^2/variance) [1/s]: sqrt(2 D:D) of a linear flow without divergence,
  /// D being the rate of strain.
  Real* strain = nullptr;
};

/// drho_i/dt = -rho_i div u + delta h c sum_j V_j psi_ij.grad W,
/// psi_ij = 2 (rho_j - rho_i) r_ji/|r_ji|^2 - (grad rho_i + grad rho_j)
/// [Antuono et al., Comput. Phys. Commun. 181 (2010) 532; Marrone et al. 2011, eqs. 5 to 7], and the strain, of the
/// block's particles. Inside the fluid the divergence is the trace of sum_j V_j (u_j - u_i) (x) L_i grad W, L_i being
/// the inverse of the matrix of WaterSums::wholeness: exact where u is linear, however uneven the particles are [P. W.
/// Randles & L. D. Libersky, Comput. Methods Appl. Mech. Eng. 139 (1996) 375]; near a surface it is sum_j V_j (u_j -
/// u_i).grad W.
template <typename Real>
void ComputeDensityRates(const PassInput<Real>& input, const WaterInput<Real>& water, const ListBlock& block,
                         const DensitySums<Real>& sums);

/// What the force pass writes beside accelerations, of the block's particles.
template <typename Real>
struct WaterSums {
  Real* gradient_x =
      nullptr;  ///< of density, renormalised [kg/m^4]; 0 where the particle has neighbours on one side only
  Real* gradient_y = nullptr;
  Real* wholeness = nullptr;  ///< least eigenvalue of sum_j V_j (x_j - x_i) (x) grad W: 1 inside, 0 for a lone particle
  /// sum_j V_j [1 + 0.2 (W/W(dx))^4] grad W, the part that the surface leaves, plus 2 min(1, wholeness/0.55)
  /// min(1, S R/(0.02 c)) times sum_j V_j [1 - (r/(0.7 dx))^2] grad W over those that are closer than 0.7 dx [1/m]
  Real* shift_x = nullptr;
  Real* shift_y = nullptr;
  /// sum_j V_j W, the particle itself included; 0 where wholeness, of the step before, falls by more than 0.2 within a
  /// support radius, as it does beside a surface
  Real* concentration = nullptr;
};

/// Adds to the accelerations [m/s^2] of the block's particles
///   -1/rho_i sum_j V_j (p_j +- p_i) grad W                                [minus: Sun et al. 2017, tensile control]
///   + 2 mu/rho_i sum_j V_j (u_j - u_i) w(r)                               [Morris, Fox & Zhu 1997, eq. 22]
///   + alpha h c rho0/rho_i sum_j V_j (u_j - u_i).r_ji/|r_ji|^2 grad W     [Monaghan & Gingold 1983]
/// and computes `sums`. w is -W'/r of the septic spline of the same support, times A - B s^2, which takes away its
/// fourth moment: a Laplacian of fourth order whose sums over lattices are right to 5e-4 (see SepticSpline). Lists that
/// are coarse become shorter.
template <typename Real>
void AddWaterForces(const PassInput<Real>& input, const WaterInput<Real>& water, ListBlock& block, double* ax,
                    double* ay, const WaterSums<Real>& sums);

}  // namespace sph
