#include "neighbours/cluster_boxes.hpp"

#include <algorithm>

namespace sph {
namespace {

Box BoxOf(const Cluster& cluster, std::span<const double> x, std::span<const double> y) {
  Box box{x[cluster.first], y[cluster.first], x[cluster.first], y[cluster.first]};
  for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
    box = {std::min(box.x0, x[i]), std::min(box.y0, y[i]), std::max(box.x1, x[i]), std::max(box.y1, y[i])};
  }
  return box;
}

}  // namespace

void ClusterBoxes::Update(const ClusterOrder& order, std::span<const double> x, std::span<const double> y) {
  const auto clusters = order.Clusters();
  columns_ = order.Columns();
  const std::size_t n = clusters.size();
  boxes_.resize(n);
  highest_so_far_.resize(n);
  lowest_to_come_.resize(n);
  for (std::size_t k = 0; k < n; ++k) boxes_[k] = BoxOf(clusters[k], x, y);
  for (auto* values : {&column_x0_, &column_x1_, &rightmost_so_far_, &leftmost_to_come_})
    values->resize(columns_.size());
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const auto [first, last] = columns_[c];
    double highest = boxes_[first].y1;
    double lowest = boxes_[last - 1].y0;
    column_x0_[c] = boxes_[first].x0;
    column_x1_[c] = boxes_[first].x1;
    for (std::uint32_t k = first; k < last; ++k) {
      highest_so_far_[k] = highest = std::max(highest, boxes_[k].y1);
      const std::uint32_t from_top = first + last - 1 - k;
      lowest_to_come_[from_top] = lowest = std::min(lowest, boxes_[from_top].y0);
      column_x0_[c] = std::min(column_x0_[c], boxes_[k].x0);
      column_x1_[c] = std::max(column_x1_[c], boxes_[k].x1);
    }
  }
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    rightmost_so_far_[c] = c == 0 ? column_x1_[c] : std::max(rightmost_so_far_[c - 1], column_x1_[c]);
  }
  for (std::size_t c = columns_.size(); c-- > 0;) {
    leftmost_to_come_[c] = c + 1 == columns_.size() ? column_x0_[c] : std::min(leftmost_to_come_[c + 1], column_x0_[c]);
  }
}

std::size_t ClusterBoxes::Bytes() const {
  return sizeof(Box) * boxes_.capacity() +
         sizeof(double) * (highest_so_far_.capacity() + lowest_to_come_.capacity() + 4 * column_x0_.capacity());
}

}  // namespace sph
