// Numbers of particles with which a block of fluid can be filled.
#pragma once

#include <cstddef>

#include "particles/placement.hpp"

namespace sph {

/// The number of particles nearest to `wanted`, less than `factor` times more or fewer, whose square lattice fills the
/// box with whole rows and columns; 0 if there is none.
std::size_t NearestFilling(const Box& box, double wanted, double factor);

/// Whether a block's particles stand in rows and columns of a box at first, or near them.
bool IsLatticeInBox(const Block& block);

}  // namespace sph
