#include "neighbours/cluster_order.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/check.hpp"
#include "base/memory.hpp"

namespace sph {
namespace {

double Median(std::span<const double> values) {
  std::vector<double> sorted;
  std::ranges::copy_if(values, std::back_inserter(sorted), [](double value) { return std::isfinite(value); });
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

/// One axis of the grid of bins: bin = (value - start) / width, outliers in the first and last bin.
struct Axis {
  double start = 0;
  double per_width = 0;
  double bins = 1;

  std::uint32_t Bin(double value) const {
    const double place = (value - start) * per_width;
    return place > 0 ? static_cast<std::uint32_t>(std::min(place, bins - 1)) : 0;  // 0 for what is not a number, too
  }
};

/// An axis over all values, or, if that takes more than `most` bins, over those around the median.
Axis Cover(std::span<const double> values, double width, double most) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double wanted = std::floor((*greatest - *least) / width) + 1;
  if (wanted <= most) return {*least, 1 / width, wanted};
  if (!std::isfinite(*greatest - *least)) return {};  // some are nowhere, which whoever moved them there finds
  return {Median(values) - 0.5 * most * width, 1 / width, most};
}

}  // namespace

void ClusterOrder::Sort(std::span<const double> x, std::span<const double> y, double spacing, double support,
                        int lanes) {
  SPH_CHECK(spacing > 0 && support > 0 && lanes > 0, "spacing = {}, support = {}, lanes = {}", spacing, support, lanes);
  const std::size_t n = x.size();
  order_.resize(n);
  column_begin_.assign(1, 0);
  if (n == 0) return;
  // Bins of a quarter of a spacing put a column's particles in order well enough for compact clusters.
  const double width = std::min(std::sqrt(static_cast<double>(lanes)) * spacing, kLongestInSupports * support);
  const double most_bins = 8.0 * static_cast<double>(n) + 1024;
  const Axis columns = Cover(x, width, std::floor(std::sqrt(most_bins)));
  const Axis rows = Cover(y, 0.25 * spacing, std::floor(most_bins / columns.bins));
  const auto row_count = static_cast<std::uint32_t>(rows.bins);
  const auto column_count = static_cast<std::uint32_t>(columns.bins);

  begin_.assign(static_cast<std::size_t>(column_count) * row_count + 1, 0);
  const auto bin_of = [&](std::size_t i) { return columns.Bin(x[i]) * row_count + rows.Bin(y[i]); };
  for (std::size_t i = 0; i < n; ++i) ++begin_[bin_of(i) + 1];
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  for (std::uint32_t c = 1; c <= column_count; ++c) {
    column_begin_.push_back(begin_[static_cast<std::size_t>(c) * row_count]);
  }
  for (std::size_t i = 0; i < n; ++i) order_[begin_[bin_of(i)]++] = static_cast<std::uint32_t>(i);
}

void ClusterOrder::Cut(std::span<const double> x, std::span<const double> y, double support, int lanes) {
  clusters_.clear();
  columns_.clear();
  const double longest = kLongestInSupports * support;
  for (std::size_t c = 0; c + 1 < column_begin_.size(); ++c) {
    const auto first_cluster = static_cast<std::uint32_t>(clusters_.size());
    Box box;
    for (std::uint32_t k = column_begin_[c]; k < column_begin_[c + 1]; ++k) {
      const Box grown{std::min(box.x0, x[k]), std::min(box.y0, y[k]), std::max(box.x1, x[k]), std::max(box.y1, y[k])};
      const bool full =
          clusters_.size() == first_cluster || clusters_.back().count == static_cast<std::uint32_t>(lanes);
      if (full || grown.Width() > longest || grown.Height() > longest) {
        MakeRoom(clusters_, clusters_.size() + 1);
        clusters_.push_back({k, 0});
        box = {x[k], y[k], x[k], y[k]};
      } else {
        box = grown;
      }
      ++clusters_.back().count;
    }
    const auto last_cluster = static_cast<std::uint32_t>(clusters_.size());
    if (last_cluster > first_cluster) columns_.push_back({first_cluster, last_cluster});
  }
}

void ClusterOrder::Transfer(Archive& archive, std::size_t particles) {
  const auto pairs = [&](auto& items, auto first, auto second) {
    std::vector<std::uint32_t> numbers;
    for (auto& item : items) numbers.insert(numbers.end(), {item.*first, item.*second});
    archive(numbers);
    items.resize(numbers.size() / 2);
    for (std::size_t k = 0; k < items.size(); ++k) {
      items[k].*first = numbers[2 * k];
      items[k].*second = numbers[2 * k + 1];
    }
  };
  pairs(clusters_, &Cluster::first, &Cluster::count);
  pairs(columns_, &Column::first, &Column::last);
  std::size_t expected = 0;
  for (const Cluster& cluster : clusters_) {
    Archive::Require(cluster.first == expected && cluster.count > 0);
    expected += cluster.count;
  }
  Archive::Require(expected == particles);
  expected = 0;
  for (const Column& column : columns_) {
    Archive::Require(column.first == expected && column.last > column.first);
    expected = column.last;
  }
  Archive::Require(expected == clusters_.size());
}

std::size_t ClusterOrder::Bytes() const {
  return sizeof(std::uint32_t) * (begin_.capacity() + order_.capacity() + column_begin_.capacity()) +
         sizeof(Cluster) * clusters_.capacity() + sizeof(Column) * columns_.capacity();
}

}  // namespace sph
