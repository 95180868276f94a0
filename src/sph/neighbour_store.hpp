// The paper's neighbour arrays (V-C), without their limits: for each particle the others within reach, and how far they
// are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/cell_grid.hpp"

namespace sph {

/// The neighbours of the particles first ... first + count - 1, in the order in which they were found.
class NeighbourBlock {
 public:
  /// Finds the neighbours j != i with |x_i - x_j| < reach of `count` particles from `first` on. The particles are in
  /// the order of the grid.
  void Find(const CellGrid& grid, std::span<const double> x, std::span<const double> y, double reach, std::size_t first,
            std::size_t count);

  std::size_t First() const { return first_; }
  std::size_t Size() const { return begin_.size() - 1; }
  /// Of the k-th particle of the block: the numbers of its neighbours, and their distances [m].
  std::span<const std::uint32_t> Numbers(std::size_t k) const {
    return {number_.data() + begin_[k], begin_[k + 1] - begin_[k]};
  }
  std::span<const double> Distances(std::size_t k) const {
    return {distance_.data() + begin_[k], begin_[k + 1] - begin_[k]};
  }
  /// Neighbours of all the particles of the block together.
  std::size_t Pairs() const { return begin_.back(); }
  std::size_t Bytes() const {
    return begin_.capacity() * sizeof(begin_[0]) + number_.capacity() * sizeof(number_[0]) +
           distance_.capacity() * sizeof(distance_[0]);
  }

 private:
  std::size_t first_ = 0;
  std::vector<std::uint32_t> begin_ = {0};  // [particles + 1]
  std::vector<std::uint32_t> number_;       // [pairs, and room to write ahead]
  std::vector<double> distance_;
};

/// Blocks of particles are the units of work: each is written by one thread only, and does not depend on their number.
using NeighbourStore = std::vector<NeighbourBlock>;
inline constexpr std::size_t kParticlesPerBlock = 256;

}  // namespace sph
