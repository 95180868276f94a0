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
  if (ends_.Any()) FindImages(x, y);
  travelled_when_made_ = travelled_;
  const auto clusters = static_cast<std::uint32_t>(order_.Clusters().size());
  blocks_.resize((clusters + kClustersPerBlock - 1) / kClustersPerBlock);
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    blocks_[b].first = b * kClustersPerBlock;
    blocks_[b].last = std::min(clusters, (b + 1) * kClustersPerBlock);
    if (just_sorted_) blocks_[b].hints.clear();
    blocks_[b].image_hints.clear();
  }
}

void NeighbourSearch::FindImages(std::span<const double> x, std::span<const double> y) {
  images_.Find(ends_, Reach(), x, y);
  images_.Place(ends_, x, y, image_x_, image_y_);
  image_order_.Sort(image_x_, image_y_, spacing_, support_, lanes_);
  images_.Reorder(image_order_.Order());
  images_.Place(ends_, x, y, image_x_, image_y_);
  image_order_.Cut(image_x_, image_y_, support_, lanes_);
  image_boxes_.Update(image_order_, image_x_, image_y_);
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
  if (!sorted_) return;
  order_.Transfer(archive, particles);
  images_.Transfer(archive, particles);
  image_order_.Transfer(archive, images_.Size());
  std::uint64_t blocks = blocks_.size();
  archive(blocks);
  const std::size_t clusters = order_.Clusters().size();
  Archive::Require(blocks == (clusters + kClustersPerBlock - 1) / kClustersPerBlock);
  blocks_.resize(blocks);
  for (std::size_t b = 0; b < blocks; ++b) {
    blocks_[b].Transfer(archive, particles + images_.Size());
    Archive::Require(blocks_[b].first == b * kClustersPerBlock);
    Archive::Require(blocks_[b].last == std::min(clusters, (b + 1) * kClustersPerBlock));
  }
  if (lanes_ != lanes) Invalidate();
}

std::size_t NeighbourSearch::Bytes() const {
  std::size_t bytes = order_.Bytes() + boxes_.Bytes() + images_.Bytes() + image_order_.Bytes() + image_boxes_.Bytes() +
                      sizeof(double) * (image_x_.capacity() + image_y_.capacity());
  for (const ListBlock& block : blocks_) {
    bytes += sizeof(std::uint32_t) * (block.begin.capacity() + block.numbers.capacity() + block.hints.capacity());
  }
  return bytes;
}

}  // namespace sph
