#include "neighbours/neighbour_search.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

/// Clusters grow as their particles drift apart; lists that are longer by this factor cost more than sorting now and
/// then. Measured from 1.04 to 1.15.
constexpr double kLongestList = 1.05;
/// In supports, and one more than when they were cut. Beyond it Positions might take far particles for near ones.
constexpr double kLongestCluster = ClusterOrder::kLongestInSupports + 1;

/// How far it gets in that time, or stays from there [m].
double GreatestTravel(std::span<const ClusterCourse> courses, double horizon) {
  double greatest = 0;
  for (const ClusterCourse& course : courses) greatest = std::max(greatest, TravelOf(course, horizon));
  return greatest;
}

}  // namespace

SearchTask NeighbourSearch::NextTask(double time, double support) {
  if (!sorted_ || support != support_ || pairs_per_area_ > kLongestList * pairs_per_area_when_sorted_) {
    support_ = support;
    return SearchTask::kSort;
  }
  return !keep_lists_ || courses_.Over(time) ? SearchTask::kLists : SearchTask::kNothing;
}

void NeighbourSearch::Sort(std::span<const double> x, std::span<const double> y, double spacing, int lanes) {
  lanes_ = lanes;
  spacing_ = spacing;
  order_.Sort(x, y, spacing, support_, lanes);
}

void NeighbourSearch::Cut(std::span<const double> x, std::span<const double> y) {
  order_.Cut(x, y, support_, lanes_);
  boxes_.Update(order_, x, y, threads_);
  sorted_ = just_sorted_ = true;
  ++sorts_;
}

bool NeighbourSearch::AreCompact(std::span<const double> x, std::span<const double> y) {
  boxes_.Update(order_, x, y, threads_);
  return boxes_.Longest() <= kLongestCluster * support_;
}

void NeighbourSearch::Prepare(const Movement& now, double least_horizon, double ends_travel) {
  courses_.SetOut(Clusters(), boxes_, now, support_, keep_lists_, least_horizon, !just_sorted_, threads_);
  greatest_travel_ = GreatestTravel(courses_.All(), courses_.Horizon()) + ends_travel;
  if (ends_.Any() || Extras() > 0) FindExtras(now.x, now.y, ends_travel);
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

void NeighbourSearch::FindExtras(std::span<const double> x, std::span<const double> y, double ends_travel) {
  const Ends ends = ends_.WithImages();
  // The fluid that wall particles near a seam see is beyond it, as far again.
  const double far = ends_.site_spacing > 0 ? 2 : 1;
  images_.Find(ends, far * support_, far * greatest_travel_, x, y);
  Arrange(
      image_clusters_, [&] { images_.Place(ends, x, y, image_clusters_.x, image_clusters_.y); },
      [&](std::span<const std::uint32_t> order) { images_.Reorder(order); });
  SetImagesOnCourse(ends_travel);
  wall_sites_.Find(ends_, support_ + greatest_travel_, x, y);
  Arrange(
      wall_clusters_,
      [&] {
        wall_clusters_.x.clear();
        wall_clusters_.y.clear();
        wall_sites_.Place(ends_, wall_clusters_.x, wall_clusters_.y);
      },
      [&](std::span<const std::uint32_t> order) { wall_sites_.Reorder(order); });
  wall_clusters_.courses.assign(wall_clusters_.order.Clusters().size(), {0, 0, static_cast<float>(ends_travel)});
}

/// An image goes where its particle's cluster takes it, turned round in mirrors.
void NeighbourSearch::SetImagesOnCourse(double ends_travel) {
  const auto clusters = order_.Clusters();
  const auto course_of = [&](std::size_t image) {
    const auto after = std::ranges::upper_bound(clusters, images_.Sources()[image], {}, &Cluster::first);
    ClusterCourse course = courses_.All()[static_cast<std::size_t>(after - clusters.begin()) - 1];
    if (Mirrored(images_.InX()[image])) course.vx = -course.vx;
    if (Mirrored(images_.InY()[image])) course.vy = -course.vy;
    return course;
  };
  image_clusters_.courses.clear();
  for (const Cluster& cluster : image_clusters_.order.Clusters()) {
    ClusterCourse common = course_of(cluster.first);
    for (std::uint32_t k = cluster.first; k < cluster.first + cluster.count; ++k) {
      const ClusterCourse own = course_of(k);
      const double apart = TravelOf({own.vx - common.vx, own.vy - common.vy, own.stray}, courses_.Horizon());
      common.stray = std::max(common.stray, static_cast<float>(apart + ends_travel));
    }
    image_clusters_.courses.push_back(common);
  }
}

ClusterSets NeighbourSearch::Sets() const {
  const auto clusters = order_.Clusters();
  const std::uint32_t particles = clusters.empty() ? 0 : clusters.back().first + clusters.back().count;
  const auto walls = particles + static_cast<std::uint32_t>(images_.Size());
  return {ClusterSet{clusters, &boxes_, courses_.All(), 0},
          {image_clusters_.order.Clusters(), &image_clusters_.boxes, image_clusters_.courses, particles},
          {wall_clusters_.order.Clusters(), &wall_clusters_.boxes, wall_clusters_.courses, walls}};
}

void NeighbourSearch::PlaceExtras(const Ends& ends, std::span<const double> x, std::span<const double> y,
                                  std::vector<double>& extra_x, std::vector<double>& extra_y) const {
  images_.Place(ends.WithImages(), x, y, extra_x, extra_y);
  wall_sites_.Place(ends, extra_x, extra_y);
}

void NeighbourSearch::Finish() {
  ++lists_made_;
  pairs_ = 0;
  double areas = 0;  // within reach of a cluster, over that within the support
  for (const ListBlock& block : blocks_) {
    pairs_ += block.begin.back();
    for (const float reach : block.reach) areas += static_cast<double>(reach) * static_cast<double>(reach);
  }
  pairs_per_area_ = pairs_ == 0 ? 0 : static_cast<double>(pairs_) / (areas / static_cast<double>(Clusters().size()));
  if (just_sorted_) pairs_per_area_when_sorted_ = pairs_per_area_;
  just_sorted_ = false;
}

void NeighbourSearch::Transfer(Archive& archive, std::size_t particles, int lanes) {
  archive(sorted_, just_sorted_, lanes_, spacing_, support_, greatest_travel_);
  archive(pairs_, pairs_per_area_, pairs_per_area_when_sorted_, lists_made_, sorts_);
  archive(ends_.x.low, ends_.x.high, ends_.x.periodic, ends_.y.low, ends_.y.high, ends_.y.periodic);
  archive(ends_.site_spacing);
  if (!sorted_) return;
  order_.Transfer(archive, particles);
  boxes_.Transfer(archive, order_.Clusters().size());
  courses_.Transfer(archive, order_.Clusters().size(), particles);
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
  std::size_t bytes = order_.Bytes() + boxes_.Bytes() + courses_.Bytes() + images_.Bytes() + wall_sites_.Bytes();
  for (const Extra* extra : {&image_clusters_, &wall_clusters_}) {
    bytes += extra->order.Bytes() + extra->boxes.Bytes() + 2 * sizeof(double) * extra->x.capacity() +
             sizeof(ClusterCourse) * extra->courses.capacity();
  }
  for (const auto* blocks : {&blocks_, &wall_blocks_}) {
    for (const ListBlock& block : *blocks) {
      bytes += sizeof(std::uint32_t) * (block.begin.capacity() + block.numbers.capacity());
      bytes += sizeof(float) * block.reach.capacity();
      for (const auto& hints : block.hints) bytes += sizeof(std::uint32_t) * hints.capacity();
    }
  }
  return bytes;
}

}  // namespace sph
