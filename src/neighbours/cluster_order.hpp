// Particles in clusters of as many as a vector register has lanes: sorted into columns, up each column, and cut.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/vec2.hpp"

namespace sph {

/// Consecutive particles first ... first + count - 1, count <= lanes, all within `box` [m].
struct Cluster {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The clusters first ... last - 1 are those of one column, from the bottom up.
struct Column {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Square clusters have the fewest neighbours for their size [S. Pall and B. Hess, Comput. Phys. Commun. 184 (2013)
/// 2641]: columns are sqrt(lanes) particles wide, and every `lanes` particles up a column make a cluster. No cluster is
/// longer than kLongestInSupports, so that differences of positions within a cluster's reach stay small numbers.
class ClusterOrder {
 public:
  static constexpr double kLongestInSupports = 3;

  /// Finds columns and order for particles about `spacing` [m] apart. Memory stays in proportion to the number of
  /// particles, however far some of them have escaped; some may even be nowhere (not a number, infinite).
  void Sort(std::span<const double> x, std::span<const double> y, double spacing, double support, int lanes);

  /// Order()[k] is the index, in the arrays that Sort was given, of the particle that is k-th from now on.
  std::span<const std::uint32_t> Order() const { return order_; }

  /// Cuts the columns into clusters; x and y are in the new order.
  void Cut(std::span<const double> x, std::span<const double> y, double support, int lanes);

  /// What Cut has made of `particles` particles.
  void Transfer(Archive& archive, std::size_t particles);

  std::span<const Cluster> Clusters() const { return clusters_; }
  std::span<const Column> Columns() const { return columns_; }
  std::size_t Bytes() const;

 private:
  std::vector<std::uint32_t> begin_;         // [bins + 1]: first particle of each bin, column by column
  std::vector<std::uint32_t> order_;         // [particles]
  std::vector<std::uint32_t> column_begin_;  // [columns + 1]: first particle of each column
  std::vector<Cluster> clusters_;
  std::vector<Column> columns_;
};

}  // namespace sph
