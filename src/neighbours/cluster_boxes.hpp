// Where the clusters are, and which of them may be near a box: the paper's FindCells (V-B) for clusters in place of
// cells.
#pragma once

#include <span>
#include <vector>

#include "neighbours/cluster_order.hpp"

namespace sph {

/// The box with `margin` [m] around it.
inline Box Grown(const Box& box, double margin) {
  return {box.x0 - margin, box.y0 - margin, box.x1 + margin, box.y1 + margin};
}
inline bool Touch(const Box& a, const Box& b) { return a.x0 <= b.x1 && a.x1 >= b.x0 && a.y0 <= b.y1 && a.y1 >= b.y0; }

class ClusterBoxes {
 public:
  /// Boxes [m] of all clusters, and what FindCells needs. x and y are in the order that was cut.
  void Update(const ClusterOrder& order, std::span<const double> x, std::span<const double> y, int threads = 1);

  const Box& Of(std::size_t cluster) const { return boxes_[cluster]; }
  /// Length of the longest side of all boxes [m].
  double Longest() const;

  /// Calls visit(k) for the clusters whose boxes touch `around`, column by column from the bottom up. `hints` remembers
  /// where the last search of a column ended: searches for clusters near each other find their place in a few steps.
  template <typename Visit>
  void FindCells(const Box& around, std::vector<std::uint32_t>& hints, Visit visit) const;

  /// The boxes alone, not what FindCells needs.
  void Transfer(Archive& archive, std::size_t clusters);
  std::size_t Bytes() const;

 private:
  void UpdateColumn(std::size_t column, std::span<const Cluster> clusters, std::span<const double> x,
                    std::span<const double> y);

  std::span<const Column> columns_;
  std::vector<Box> boxes_;
  // Up a column, no cluster before k ends above highest_so_far_[k] and none from k on begins below lowest_to_come_[k];
  // the same for the columns in x. Both grow with k, so what may touch a box is one run, wherever the particles have
  // drifted to.
  std::vector<double> highest_so_far_, lowest_to_come_;      // [clusters]
  std::vector<double> column_x0_, column_x1_;                // [columns]
  std::vector<double> rightmost_so_far_, leftmost_to_come_;  // [columns]
};

template <typename Visit>
void ClusterBoxes::FindCells(const Box& around, std::vector<std::uint32_t>& hints, Visit visit) const {
  const std::size_t columns = columns_.size();
  if (hints.size() != columns + 1) {
    hints.assign(columns + 1, 0);
    for (std::size_t c = 0; c < columns; ++c) hints[c] = columns_[c].first;
  }
  // The least k in [first, last) with values[k] >= bound, searched from the hint on.
  const auto walk = [](const std::vector<double>& values, std::size_t first, std::size_t last, std::size_t k,
                       double bound) {
    while (k > first && values[k - 1] >= bound) --k;
    while (k < last && values[k] < bound) ++k;
    return k;
  };
  const std::size_t c0 = walk(rightmost_so_far_, 0, columns, hints[columns], around.x0);
  hints[columns] = static_cast<std::uint32_t>(c0);
  for (std::size_t c = c0; c < columns && leftmost_to_come_[c] <= around.x1; ++c) {
    if (column_x1_[c] < around.x0 || column_x0_[c] > around.x1) continue;
    const Column& column = columns_[c];
    const std::size_t k0 = walk(highest_so_far_, column.first, column.last, hints[c], around.y0);
    hints[c] = static_cast<std::uint32_t>(k0);
    for (std::size_t k = k0; k < column.last && lowest_to_come_[k] <= around.y1; ++k) {
      if (Touch(boxes_[k], around)) visit(k);
    }
  }
}

}  // namespace sph
