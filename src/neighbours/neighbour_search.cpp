#include "neighbours/neighbour_search.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

/// Clusters grow as their particles drift apart; lists that are longer by this factor cost more than sorting now and
/// then. Measured from 1.04 to 1.15.
constexpr double kLongestList = 1.05;

/// The skin that costs least [m]. Passes over lists with reach R (1 + s) take longer in proportion to 1 + 1.1 s (the
/// area within reach of a square cluster of 16 particles), and lists are made anew every s R/(2 u) steps, u being the
/// travel per step. The least of P 1.1 s + B 2 u/(s R) is at s = sqrt(2 B u/(1.1 P R)); making the lists costs B = 0.28
/// P, the two passes.
double BestSkin(double support, double travel_per_step) {
  const double skin = std::sqrt(0.5 * travel_per_step * support);
  const double steps = skin / (2 * travel_per_step);
  return travel_per_step > 0 && steps < 1.5 ? 0.0 : std::clamp(skin, 0.001 * support, 0.3 * support);
}

}  // namespace

SearchTask NeighbourSearch::NextTask(double travelled, double support) {
  travelled_ = travelled;
  if (!sorted_ || support != support_ || pairs_per_area_ > kLongestList * pairs_per_area_when_sorted_) {
    support_ = support;
    return SearchTask::kSort;
  }
  return !keep_lists_ || 2 * (travelled_ - travelled_when_made_) > skin_ ? SearchTask::kLists : SearchTask::kNothing;
}

void NeighbourSearch::Sort(std::span<const double> x, std::span<const double> y, double spacing, int lanes) {
  lanes_ = lanes;
  spacing_ = spacing;
  order_.Sort(x, y, spacing, support_, lanes);
}

void NeighbourSearch::Cut(std::span<const double> x, std::span<const double> y) {
  order_.Cut(x, y, support_, lanes_);
  sorted_ = just_sorted_ = true;
  ++sorts_;
}

void NeighbourSearch::Prepare(std::span<const double> x, std::span<const double> y, double travel_per_step,
                              double least_skin) {
  boxes_.Update(order_, x, y, threads_);
  skin_ = std::max(least_skin, keep_lists_ ? BestSkin(support_, travel_per_step) : 0);
  if (ends_.Any() || Extras() > 0) FindExtras(x, y);
  travelled_when_made_ = travelled_;
  EmptyBlocks(blocks_, order_.Clusters().size());
  EmptyBlocks(wall_blocks_, wall_clusters_.order.Clusters().size());
}

void NeighbourSearch::EmptyBlocks(std::vector<ListBlock>& blocks, std::size_t clusters) const {
  blocks.resize((clusters + kClustersPerBlock - 1) / kClustersPerBlock);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    blocks[b].first = static_cast<std::uint32_t>(b * kClustersPerBlock);
    blocks[b].last = static_cast<std::uint32_t>(std::min(clusters, (b + 1) * kClustersPerBlock));
    for (std::size_t set = just_sorted_ ? 0 : 1; set < blocks[b].hints.size(); ++set) blocks[b].hints[set].clear();
  }
}

template <typename Place, typename Reorder>
void NeighbourSearch::Arrange(Extra& extra, Place place, Reorder reorder) {
  place();
  extra.order.Sort(extra.x, extra.y, spacing_, support_, lanes_);
  reorder(extra.order.Order());
  place();
  extra.order.Cut(extra.x, extra.y, support_, lanes_);
  extra.boxes.Update(extra.order, extra.x, extra.y);
}

void NeighbourSearch::FindExtras(std::span<const double> x, std::span<const double> y) {
  const Ends ends = ends_.WithImages();
  // The fluid that wall particles near a seam see is beyond it, as far again.
  images_.Find(ends, ends_.site_spacing > 0 ? 2 * Reach() : Reach(), x, y);
  Arrange(
      image_clusters_, [&] { images_.Place(ends, x, y, image_clusters_.x, image_clusters_.y); },
      [&](std::span<const std::uint32_t> order) { images_.Reorder(order); });
  wall_sites_.Find(ends_, Reach(), x, y);
  Arrange(
      wall_clusters_,
      [&] {
        wall_clusters_.x.clear();
        wall_clusters_.y.clear();
        wall_sites_.Place(ends_, wall_clusters_.x, wall_clusters_.y);
      },
      [&](std::span<const std::uint32_t> order) { wall_sites_.Reorder(order); });
}

ClusterSets NeighbourSearch::Sets() const {
  const auto clusters = order_.Clusters();
  const std::uint32_t particles = clusters.empty() ? 0 : clusters.back().first + clusters.back().count;
  const auto walls = particles + static_cast<std::uint32_t>(images_.Size());
  return {ClusterSet{clusters, &boxes_, 0},
          {image_clusters_.order.Clusters(), &image_clusters_.boxes, particles},
          {wall_clusters_.order.Clusters(), &wall_clusters_.boxes, walls}};
}

void NeighbourSearch::PlaceExtras(const Ends& ends, std::span<const double> x, std::span<const double> y,
                                  std::vector<double>& extra_x, std::vector<double>& extra_y) const {
  images_.Place(ends.WithImages(), x, y, extra_x, extra_y);
  wall_sites_.Place(ends, extra_x, extra_y);
}

void NeighbourSearch::Finish() {
  ++lists_made_;
  pairs_ = 0;
  for (const ListBlock& block : blocks_) pairs_ += block.begin.back();
  const double relative_reach = Reach() / support_;
  pairs_per_area_ = static_cast<double>(pairs_) / (relative_reach * relative_reach);
  if (just_sorted_) pairs_per_area_when_sorted_ = pairs_per_area_;
  just_sorted_ = false;
}

void NeighbourSearch::Transfer(Archive& archive, std::size_t particles, int lanes) {
  archive(sorted_, just_sorted_, lanes_, spacing_, support_, skin_, travelled_, travelled_when_made_);
  archive(pairs_, pairs_per_area_, pairs_per_area_when_sorted_, lists_made_, sorts_);
  archive(ends_.x.low, ends_.x.high, ends_.x.periodic, ends_.y.low, ends_.y.high, ends_.y.periodic);
  archive(ends_.site_spacing);
  if (!sorted_) return;
  order_.Transfer(archive, particles);
  images_.Transfer(archive, particles);
  image_clusters_.order.Transfer(archive, images_.Size());
  wall_sites_.Transfer(archive);
  wall_clusters_.order.Transfer(archive, wall_sites_.Size());
  const auto transfer = [&](std::vector<ListBlock>& blocks, std::size_t clusters) {
    std::uint64_t count = blocks.size();
    archive(count);
    Archive::Require(count == (clusters + kClustersPerBlock - 1) / kClustersPerBlock);
    blocks.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
      blocks[b].Transfer(archive, particles + Extras());
      Archive::Require(blocks[b].first == b * kClustersPerBlock);
      Archive::Require(blocks[b].last == std::min(clusters, (b + 1) * kClustersPerBlock));
    }
  };
  transfer(blocks_, order_.Clusters().size());
  transfer(wall_blocks_, wall_clusters_.order.Clusters().size());
  if (lanes_ != lanes) Invalidate();
}

std::size_t NeighbourSearch::Bytes() const {
  std::size_t bytes = order_.Bytes() + boxes_.Bytes() + images_.Bytes() + wall_sites_.Bytes();
  for (const Extra* extra : {&image_clusters_, &wall_clusters_}) {
    bytes += extra->order.Bytes() + extra->boxes.Bytes() + 2 * sizeof(double) * extra->x.capacity();
  }
  for (const auto* blocks : {&blocks_, &wall_blocks_}) {
    for (const ListBlock& block : *blocks) {
      bytes += sizeof(std::uint32_t) * (block.begin.capacity() + block.numbers.capacity());
      for (const auto& hints : block.hints) bytes += sizeof(std::uint32_t) * hints.capacity();
    }
  }
  return bytes;
}

}  // namespace sph
