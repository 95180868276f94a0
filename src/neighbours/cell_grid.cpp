#include "neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace sph {
namespace {

double Median(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

}  // namespace

void CellGrid::Cover(std::span<const double> x, std::span<const double> y, double side) {
  SPH_CHECK(side > 0, "side = {}", side);
  cells_per_metre_ = 1 / side;
  columns_ = rows_ = 1;
  x0_ = y0_ = 0;
  if (x.empty()) return;
  const auto [x_least, x_greatest] = std::minmax_element(x.begin(), x.end());
  const auto [y_least, y_greatest] = std::minmax_element(y.begin(), y.end());
  x0_ = *x_least;
  y0_ = *y_least;
  SPH_CHECK(std::isfinite(*x_greatest - x0_) && std::isfinite(*y_greatest - y0_), "positions from ({}, {}) to ({}, {})",
            x0_, y0_, *x_greatest, *y_greatest);
  const double most_cells = 4.0 * static_cast<double>(x.size()) + 1024;
  const double wanted_columns = std::floor((*x_greatest - x0_) * cells_per_metre_) + 1;
  const double wanted_rows = std::floor((*y_greatest - y0_) * cells_per_metre_) + 1;
  if (wanted_columns * wanted_rows <= most_cells) {
    columns_ = static_cast<long>(wanted_columns);
    rows_ = static_cast<long>(wanted_rows);
    return;
  }
  // Particles that have escaped: cover what is around the middle one.
  const double shorter = std::min({wanted_columns, wanted_rows, std::floor(std::sqrt(most_cells))});
  columns_ = static_cast<long>(std::min(wanted_columns, std::floor(most_cells / shorter)));
  rows_ = static_cast<long>(std::min(wanted_rows, std::floor(most_cells / static_cast<double>(columns_))));
  x0_ = Median(x) - 0.5 * static_cast<double>(columns_) * side;
  y0_ = Median(y) - 0.5 * static_cast<double>(rows_) * side;
}

long CellGrid::Column(double x) const {
  return static_cast<long>(std::clamp((x - x0_) * cells_per_metre_, 0.0, static_cast<double>(columns_ - 1)));
}

long CellGrid::Row(double y) const {
  return static_cast<long>(std::clamp((y - y0_) * cells_per_metre_, 0.0, static_cast<double>(rows_ - 1)));
}

void CellGrid::Build(std::span<const double> x, std::span<const double> y, double side) {
  Cover(x, y, side);
  const std::size_t n = x.size();
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  cell_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    cell_[i] = static_cast<std::uint32_t>(Row(y[i]) * columns_ + Column(x[i]));
    ++first_[cell_[i] + 1];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  order_.resize(n);
  in_order_ = true;
  // first_[c] serves as the next free place of cell c, and ends as the first place of cell c + 1.
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t place = first_[cell_[i]]++;
    in_order_ = in_order_ && place == i;
    order_[place] = static_cast<std::uint32_t>(i);
  }
  std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
  first_[0] = 0;
}

std::array<Run, 3> CellGrid::FindCells(Vec2 position) const {
  const long column = Column(position.x);
  const long row = Row(position.y);
  const long left = std::max(column - 1, 0L);
  const long right = std::min(column + 1, columns_ - 1);
  std::array<Run, 3> runs;
  for (long k = 0; k < 3; ++k) {
    const long r = row - 1 + k;
    if (r < 0 || r >= rows_) continue;
    const auto first_cell = static_cast<std::size_t>(r * columns_ + left);
    const auto last_cell = static_cast<std::size_t>(r * columns_ + right);
    runs[static_cast<std::size_t>(k)] = {first_[first_cell], first_[last_cell + 1]};
  }
  return runs;
}

}  // namespace sph
