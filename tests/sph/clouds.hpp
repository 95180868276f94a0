// Particles to try passes on: lattices, random clouds, clumps, coincident ones, of sizes that end blocks and vectors
// unevenly.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "neighbours/neighbour_search.hpp"
#include "sph/cluster_passes.hpp"

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

/// The cloud in the order of its clusters, and what the passes read of it.
template <typename Real>
struct Neighbourhood {
  Cloud cloud;
  NeighbourSearch search;
  Positions<Real> positions;
  std::vector<Real> mass;
  double support = 0;

  PassInput<Real> Input() const { return {&positions, support, mass.data(), 0, search.Clusters()}; }
};
template <typename Real>
Neighbourhood<Real> FindNeighbours(const Cloud& cloud, double support);

/// Calls test() with every instruction set that this processor has, and a trace that names it.
void WithEveryInstructionSet(const std::function<void()>& test);

/// The bound on |pass - twin| over the greatest value of the twin in the same cloud: a few roundings of sums of some
/// ten to some hundred terms, and in double on processors without AVX-512 the 46 bits to which two Newton steps bring a
/// 12-bit estimate.
template <typename Real>
constexpr double kTolerance = sizeof(Real) == 4 ? 2e-6 : 1e-13;

}  // namespace sph
