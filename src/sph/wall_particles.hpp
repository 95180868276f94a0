// What the particles behind a wall have of the fluid before it.
#pragma once

#include <vector>

#include "sph/delta_passes.hpp"

namespace sph {

/// Of the wall particles, in their order.
template <typename Real>
struct WallValues {
  std::vector<Real> pressure;   ///< [Pa]
  std::vector<Real> excess;     ///< rho - rho0 [kg/m^3]
  std::vector<Real> vx, vy;     ///< of the fluid there [m/s]
  std::vector<Real> wholeness;  ///< see WaterSums

  void Resize(std::size_t n) {
    for (auto* values : {&pressure, &excess, &vx, &vy, &wholeness}) values->resize(n);
  }
  std::size_t Bytes() const { return 5 * sizeof(Real) * pressure.capacity(); }
};

/// The means of the fluid's values, weighted with the kernel, of the block's clusters [S. Adami, X. Y. Hu & N. A.
/// Adams, J. Comput. Phys. 231 (2012) 7057, eqs. 22 and 27]:
///   v_w = sum_f v_f W/sum_f W,   p_w = sum_f (p_f + rho_f g.(r_w - r_f)) W/sum_f W;
/// the density's excess like the pressure, with c^2 between them, in place of their eq. 28; 0 where there is no fluid.
/// `walls` are all wall particles; `input` and `water` are of the fluid, gravity [m/s^2], sound = c [m/s].
template <typename Real>
void ComputeWallValues(const PassInput<Real>& input, const WaterInput<Real>& water, const ClusterSet& walls,
                       const ListBlock& block, Vec2 gravity, double sound, WallValues<Real>& values);

}  // namespace sph
