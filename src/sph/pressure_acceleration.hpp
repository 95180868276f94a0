// Acceleration by pressure, symmetric in the pair: a_i = -sum_j m_j (P_i/rho_i^2 + P_j/rho_j^2) grad_i W_ij
// [Braune & Lewiner eq. 10].
#pragma once

#include <span>

#include "sph/neighbour_store.hpp"

namespace sph {

/// Adds to (ax, ay) [m/s^2] of the block's particles. The other spans are of all particles; pressure_term is P/rho^2
/// [m^5/(kg s^2)].
template <typename Kernel>
void AddPressureAcceleration(const NeighbourBlock& block, const Kernel& kernel, std::span<const double> x,
                             std::span<const double> y, std::span<const double> mass,
                             std::span<const double> pressure_term, std::span<double> ax, std::span<double> ay) {
  for (std::size_t k = 0; k < block.Size(); ++k) {
    const std::size_t i = block.First() + k;
    const auto neighbours = block.Numbers(k);
    const auto distances = block.Distances(k);
    double sum_x = 0;
    double sum_y = 0;
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
      const std::size_t j = neighbours[n];
      const double s = mass[j] * (pressure_term[i] + pressure_term[j]) * kernel.Gradient(distances[n]);
      sum_x += s * (x[i] - x[j]);
      sum_y += s * (y[i] - y[j]);
    }
    ax[i] -= sum_x;
    ay[i] -= sum_y;
  }
}

}  // namespace sph
