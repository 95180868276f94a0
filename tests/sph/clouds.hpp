// Particles to try passes on: lattices, random clouds, clumps, coincident ones, of sizes that end blocks and vectors
// unevenly.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sph/neighbour_store.hpp"

namespace sph {

/// Element i of every array belongs to the same particle. Masses differ, so that m_i and m_j cannot be mistaken for
/// each other.
struct Cloud {
  std::string name;
  std::vector<double> x, y, vx, vy, mass;

  std::size_t Size() const { return x.size(); }
};

/// Smoothing length for which the clouds' particles have a few to a few hundred neighbours within twice of it [m].
inline constexpr double kCloudH = 0.05;

/// Every kind of cloud in every size of 0, 1, 2, 15, 16, 17, 257 and 600.
std::vector<Cloud> AllClouds();

/// The cloud in the order of the grid, and the neighbours within `reach` of all its particles, block by block.
struct Neighbourhood {
  Cloud cloud;
  NeighbourStore blocks;
};
Neighbourhood FindNeighbours(const Cloud& cloud, double reach);

}  // namespace sph
