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
  bool sharp_gradient = false, tensile_control = true;
  std::vector<double> excess, pressure, gradient_x, gradient_y, wholeness;

  double Density(std::size_t i) const { return rho0 + excess[i]; }
};

/// a and b such that -W'/r (a - b (r/2h)^2) has the second moment of -W'/r, and no fourth: by quadrature.
struct SharpWeights {
  double flat = 1, fall = 0;
};
SharpWeights SharpWeightsOf(SmoothingKernel kernel);

/// drho_i/dt; value.x is the rate.
std::vector<PlainSum> PlainDensityRates(const Cloud& cloud, const PlainWater& water);

/// dv_i/dt by pressure, viscosity and artificial viscosity.
std::vector<PlainSum> PlainWaterForces(const Cloud& cloud, const PlainWater& water);

/// What a particle knows of its surroundings, before thresholds are applied.
struct PlainSurroundings {
  double xx = 0, xy = 0, yy = 0;      ///< sum_j V_j (x_j - x_i) (x) grad W
  double greatest = 0;                ///< greater eigenvalue of that matrix
  double wholeness = 0;               ///< lesser one
  PlainSum rise, fall;                ///< sum_j V_j (f_j - f_i) grad W of excess density and of wholeness
  Vec2 gradient, wholeness_gradient;  ///< both times the inverse matrix, whatever its determinant
  PlainSum lack;                      ///< sum_j V_j [1 + 0.2 (W/W(dx))^4] grad W
};
std::vector<PlainSurroundings> SurroundingsOf(const Cloud& cloud, const PlainWater& water);

}  // namespace sph
