// The accurate solver's passes once more, in the plainest way: sums over all pairs with the kernels of kernels.hpp.
#pragma once

#include "sph/delta_passes.hpp"
#include "sph/plain_twins.hpp"

namespace sph {

/// The solver's kernels. Here and below, h is half the support radius, for the quintic spline, too.
inline constexpr SmoothingKernel kAllKernels[] = {SmoothingKernel::kWendlandC2, SmoothingKernel::kWendlandC4,
                                                  SmoothingKernel::kQuintic};
double ValueAt(SmoothingKernel kernel, double h, double r);
/// g with grad_i W = g (x_i - x_j)
double GradientAt(SmoothingKernel kernel, double h, double r);

/// rho_i = sum_j m_j W_ij.
std::vector<PlainSum> PlainGasDensity(SmoothingKernel kernel, const Cloud& cloud, double h);

/// -sum_j m_j (T_i + T_j) grad_i W_ij with terms T = P/rho^2.
std::vector<PlainSum> PlainGasPressure(SmoothingKernel kernel, const Cloud& cloud, std::span<const double> term,
                                       double h);

/// What a liquid's passes read; see WaterInput.
struct PlainWater {
  SmoothingKernel kernel = SmoothingKernel::kWendlandC2;
  double h = kCloudH;
  double rho0 = 1;
  double diffusion = 0, viscosity = 0, artificial = 0;
  double spacing = 0.5 * kCloudH;
  double variance = 0.3 * kCloudH * kCloudH;  // no kernel's
  double gradient_flat = 1, gradient_fall = 0;
  bool tensile_control = true;
  double sound = 1;
  std::vector<double> excess, pressure, gradient_x, gradient_y, wholeness, strain;

  double Density(std::size_t i) const { return rho0 + excess[i]; }
};

/// a and b such that -W'/r (a - b (r/2h)^2) has the second moment of -W'/r, and no fourth: by quadrature.
struct SharpWeights {
  double flat = 1, fall = 0;
};
SharpWeights SharpWeightsOf(SmoothingKernel kernel);

/// Variance of W, of one coordinate [m^2]: by quadrature.
double VarianceOf(SmoothingKernel kernel, double h);

/// -W'/r (A - B s^2) [1/m^4] of the septic spline whose support is 2h, the viscous force's weights.
double ViscousWeightAt(double h, double r);

struct PlainRates {
  PlainSum rate;         ///< drho_i/dt is value.x
  double strain = 0;     ///< [1/s]
  double wholeness = 0;  ///< by which the divergence's form is chosen
  double greatest = 0;   ///< the greater eigenvalue
};
std::vector<PlainRates> PlainDensityRates(const Cloud& cloud, const PlainWater& water);

/// dv_i/dt by pressure, viscosity and artificial viscosity.
std::vector<PlainSum> PlainWaterForces(const Cloud& cloud, const PlainWater& water);

/// What a particle knows of its surroundings, before thresholds are applied.
struct PlainSurroundings {
  double greatest = 0;                ///< greater eigenvalue of sum_j V_j (x_j - x_i) (x) grad W
  double wholeness = 0;               ///< lesser one
  PlainSum rise, fall;                ///< sum_j V_j (f_j - f_i) grad W of excess density and of wholeness
  Vec2 gradient, wholeness_gradient;  ///< both times the inverse of that matrix, whatever its determinant
  PlainSum lack;                      ///< sum_j V_j [1 + 0.2 (W/W(dx))^4] grad W
  PlainSum near;                      ///< sum_j V_j [1 - (r/(0.7 dx))^2] grad W over those closer than 0.7 dx
  double concentration = 0;           ///< sum_j V_j W
};
std::vector<PlainSurroundings> SurroundingsOf(const Cloud& cloud, const PlainWater& water);

}  // namespace sph
