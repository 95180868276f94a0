// Density by summation: rho_i = sum_j m_j W_ij, the particle itself included [Braune & Lewiner eq. 8].
#pragma once

#include <span>

#include "sph/neighbour_store.hpp"

namespace sph {

/// Overwrites density[i] [kg/m^3] of the block's particles. `density` and `mass` [kg/m] are of all particles.
template <typename Kernel>
void ComputeDensity(const NeighbourBlock& block, const Kernel& kernel, std::span<const double> mass,
                    std::span<double> density) {
  const double self = kernel.Value(0);
  for (std::size_t k = 0; k < block.Size(); ++k) {
    const std::size_t i = block.First() + k;
    const auto neighbours = block.Numbers(k);
    const auto distances = block.Distances(k);
    double rho = mass[i] * self;
    for (std::size_t n = 0; n < neighbours.size(); ++n) rho += mass[neighbours[n]] * kernel.Value(distances[n]);
    density[i] = rho;
  }
}

}  // namespace sph
