// The passes over neighbours, on vectors: density, pressure, and the tutorial's forces, in float and in double.
#pragma once

#include <span>

#include "neighbours/cluster_lists.hpp"

namespace sph {

/// What every pass reads. `mass` [kg/m] is of all particles; null if each has `equal_mass`.
template <typename Real>
struct PassInput {
  const Positions<Real>* positions = nullptr;
  double support = 0;  ///< [m]
  const Real* mass = nullptr;
  double equal_mass = 0;
  std::span<const Cluster> clusters;
};

/// rho_i = sum_j m_j W_ij [Braune & Lewiner eq. 8] of the block's particles, overwritten [kg/m^3]. Arrays may be
/// written up to kPadding beyond the last particle. Lists that are coarse become shorter.
template <typename Real>
void ComputeCubicSplineDensity(const PassInput<Real>& input, ListBlock& block, Real* density);
/// The same with Poly6.
template <typename Real>
void ComputePoly6Density(const PassInput<Real>& input, ListBlock& block, Real* density);

/// Adds -sum_j m_j (T_i + T_j) grad_i W_ij, T = P/rho^2 [m^5/(kg s^2)] [Braune & Lewiner eq. 10], to the accelerations
/// [m/s^2] of the block's particles.
template <typename Real>
void AddCubicSplinePressure(const PassInput<Real>& input, const ListBlock& block, const Real* pressure_term, double* ax,
                            double* ay);

/// What the tutorial's forces read beyond that, of all particles.
template <typename Real>
struct MuellerInput {
  const Real* volume = nullptr;    ///< m/rho [m^2]
  const Real* pressure = nullptr;  ///< [Pa]
  const Real* density = nullptr;   ///< [kg/m^3]
  const Real* vx = nullptr;        ///< [m/s]; not read if `viscosity` is 0
  const Real* vy = nullptr;
  double viscosity = 0;    ///< mu [Pa s]
  bool published = false;  ///< with the kernel gradient of the tutorial's program
};

/// Adds to the accelerations [m/s^2] of the block's particles [Mueller, Charypar & Gross 2003, eqs. 10 and 14, in the
/// plane]
///   1/rho_i sum_j V_j ( -(P_i + P_j)/2 W'(r) (x_i - x_j)/r + mu (v_j - v_i) lap W(r) ).
/// W' is that of Spiky, -30/(pi h^5) (h - r)^2; published, it is +10/(pi h^5) (h - r)^3: the tutorial's program has
/// that magnitude, and the sign of the direction turned round. Its pressures are all negative, because its densities
/// stay far below rho0; the two reversals cancel, and particles repel. Coincident particles exert no pressure on each
/// other.
template <typename Real>
void AddMuellerForces(const PassInput<Real>& input, const MuellerInput<Real>& mueller, const ListBlock& block,
                      double* ax, double* ay);

}  // namespace sph
