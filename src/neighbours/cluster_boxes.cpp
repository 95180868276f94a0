#include "neighbours/cluster_boxes.hpp"

#include <algorithm>

#include "base/memory.hpp"

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

void ClusterBoxes::Update(const ClusterOrder& order, std::span<const double> x, std::span<const double> y,
                          int threads) {
  constexpr std::size_t kClustersOfOneThread = 512;  // waking the others costs more than so little work
  const auto clusters = order.Clusters();
  columns_ = order.Columns();
  const auto resize = [&](auto& values) {
    MakeRoom(values, clusters.size());
    values.resize(clusters.size());
  };
  resize(boxes_), resize(highest_so_far_), resize(lowest_to_come_);
  for (auto* values : {&column_x0_, &column_x1_, &rightmost_so_far_, &leftmost_to_come_})
    values->resize(columns_.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (clusters.size() > kClustersOfOneThread)
  for (std::size_t c = 0; c < columns_.size(); ++c) UpdateColumn(c, clusters, x, y);
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    rightmost_so_far_[c] = c == 0 ? column_x1_[c] : std::max(rightmost_so_far_[c - 1], column_x1_[c]);
  }
  for (std::size_t c = columns_.size(); c-- > 0;) {
    leftmost_to_come_[c] = c + 1 == columns_.size() ? column_x0_[c] : std::min(leftmost_to_come_[c + 1], column_x0_[c]);
  }
}

void ClusterBoxes::UpdateColumn(std::size_t column, std::span<const Cluster> clusters, std::span<const double> x,
                                std::span<const double> y) {
  const auto [first, last] = columns_[column];
  Box around = boxes_[first] = BoxOf(clusters[first], x, y);
  for (std::uint32_t k = first; k < last; ++k) {
    const Box box = boxes_[k] = BoxOf(clusters[k], x, y);
    around = {std::min(around.x0, box.x0), 0, std::max(around.x1, box.x1), std::max(around.y1, box.y1)};
    highest_so_far_[k] = around.y1;
  }
  column_x0_[column] = around.x0;
  column_x1_[column] = around.x1;
  double lowest = boxes_[last - 1].y0;
  for (std::uint32_t k = last; k-- > first;) lowest_to_come_[k] = lowest = std::min(lowest, boxes_[k].y0);
}

double ClusterBoxes::Longest() const {
  double longest = 0;
  for (const Box& box : boxes_) longest = std::max({longest, box.Width(), box.Height()});
  return longest;
}

void ClusterBoxes::Transfer(Archive& archive, std::size_t clusters) {
  std::vector<double> sides;
  for (const Box& box : boxes_) sides.insert(sides.end(), {box.x0, box.y0, box.x1, box.y1});
  archive(sides);
  if (!archive.Reading()) return;
  Archive::Require(sides.size() == 4 * clusters);
  boxes_.clear();
  for (std::size_t k = 0; k < sides.size(); k += 4) {
    boxes_.push_back({sides[k], sides[k + 1], sides[k + 2], sides[k + 3]});
  }
}

std::size_t ClusterBoxes::Bytes() const {
  return sizeof(Box) * boxes_.capacity() +
         sizeof(double) * (highest_so_far_.capacity() + lowest_to_come_.capacity() + 4 * column_x0_.capacity());
}

}  // namespace sph
