#include "sph/neighbour_store.hpp"

#include <cmath>

namespace sph {

void NeighbourBlock::Find(const CellGrid& grid, std::span<const double> x, std::span<const double> y, double reach,
                          std::size_t first, std::size_t count) {
  first_ = first;
  begin_.assign(count + 1, 0);
  const double reach2 = reach * reach;
  std::uint32_t found = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = first + k;
    const auto runs = grid.FindCells({x[i], y[i]});
    std::size_t candidates = 0;
    for (const Run& run : runs) candidates += run.last - run.first;
    if (number_.size() < found + candidates) {
      number_.resize(2 * (found + candidates));
      distance_.resize(2 * (found + candidates));
    }
    const std::uint32_t begin = found;
    for (const Run& run : runs) {
      for (std::uint32_t j = run.first; j < run.last; ++j) {
        const double dx = x[i] - x[j];
        const double dy = y[i] - y[j];
        const double r2 = dx * dx + dy * dy;
        // Written always, kept only if it counts: cheaper than a branch that cannot be predicted.
        number_[found] = j;
        distance_[found] = r2;
        found += static_cast<std::uint32_t>(r2 < reach2) & static_cast<std::uint32_t>(j != i);
      }
    }
    for (std::uint32_t n = begin; n < found; ++n) distance_[n] = std::sqrt(distance_[n]);
    begin_[k + 1] = found;
  }
}

}  // namespace sph
