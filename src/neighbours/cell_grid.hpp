// The paper's grid (V-B): square cells as wide as the kernel's support, so that neighbours are in the nine cells around
// one.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace sph {

/// A run of consecutive particles in cell order: first <= k < last.
struct Run {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Cells are numbered row by row, and particles sorted by cell: neighbouring cells of a row are one run. Particles
/// outside the covered box count as being in the border cell nearest to them; two particles within a cell's side of
/// each other are still in the same or in adjoining cells, so no pair is missed.
class CellGrid {
 public:
  /// Covers the particles with cells of side `side` [m] > 0 and finds their order. Memory stays in proportion to the
  /// number of particles: where they are spread over more cells than that, the covered box ends before the outermost
  /// particles. All positions must be finite.
  void Build(std::span<const double> x, std::span<const double> y, double side);

  /// Order()[k] is the index, in the arrays that Build was given, of the particle that is k-th in cell order.
  std::span<const std::uint32_t> Order() const { return order_; }
  bool InOrder() const { return in_order_; }

  /// The paper's FindCells: the particles of the nine cells around `position`, one run for each of three rows, in the
  /// order of Order(). Rows outside the grid give empty runs.
  std::array<Run, 3> FindCells(Vec2 position) const;

  long Columns() const { return columns_; }
  long Rows() const { return rows_; }

 private:
  void Cover(std::span<const double> x, std::span<const double> y, double side);
  long Column(double x) const;
  long Row(double y) const;

  double x0_ = 0;
  double y0_ = 0;
  double cells_per_metre_ = 0;
  long columns_ = 1;
  long rows_ = 1;
  std::vector<std::uint32_t> first_;  // [columns * rows + 1]: first particle of each cell, in cell order
  std::vector<std::uint32_t> cell_;   // [particles]
  std::vector<std::uint32_t> order_;  // [particles]
  bool in_order_ = true;
};

}  // namespace sph
