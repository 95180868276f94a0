// Verlet lists of clusters: for each cluster, the particles within reach of its box.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "neighbours/cluster_boxes.hpp"
#include "neighbours/cluster_courses.hpp"
#include "neighbours/cluster_order.hpp"
#include "neighbours/positions.hpp"

namespace sph {

/// The lists of the clusters first ... last - 1: a unit of work, written by one thread.
struct ListBlock {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  bool coarse = false;                 // made by distance from a cluster's box; the next density pass, which computes
                                       // all distances anyway, keeps what is within reach of one of its particles
  std::vector<float> reach;            // [clusters]: of the longest of its lists' pairs, over the support
  std::vector<std::uint32_t> begin;    // [clusters + 1]
  std::vector<std::uint32_t> numbers;  // room for kPadding more than are valid
  std::array<std::vector<std::uint32_t>, 3> hints;  // of ClusterBoxes::FindCells: of particles, images, wall particles

  std::span<const std::uint32_t> Of(std::uint32_t cluster) const {
    return {numbers.data() + begin[cluster - first], numbers.data() + begin[cluster - first + 1]};
  }
  /// The lists of particles and images that are fewer than `end`; not the hints, which only save time.
  void Transfer(Archive& archive, std::size_t end);
  /// Overwrites `numbers`; where they outgrow their room, with a sixteenth to spare.
  void Take(std::span<const std::uint32_t> found);
};

inline constexpr std::uint32_t kClustersPerBlock = 64;

/// Number of `Real` that the instruction set in use computes with at once; see base/simd.hpp.
template <typename Real>
int Lanes();

/// Clusters, their boxes and courses, of particles whose numbers begin at `first`.
struct ClusterSet {
  std::span<const Cluster> clusters;
  const ClusterBoxes* boxes = nullptr;
  std::span<const ClusterCourse> courses;
  std::uint32_t first = 0;
};

/// What a list may hold: particles, images, wall particles.
using ClusterSets = std::array<ClusterSet, 3>;

/// How far lists reach.
struct ListReach {
  double support = 0;          ///< [m]
  double horizon = 0;          ///< for how long they are to hold [s]
  double greatest_travel = 0;  ///< until then, of any particle, image or wall particle [m]
};

/// Overwrites the lists of the block's clusters, which are some of `own`: of every set all that may come within the
/// support of the cluster's box before the horizon if both keep to their courses, and perhaps a few that just do not,
/// to round-off; one set after the other. Ascending within a column of clusters. Allocates only while lists grow.
template <typename Real>
void FindNeighbours(const ClusterSet& own, const ClusterSets& others, const Positions<Real>& positions,
                    const ListReach& reach, ListBlock& block);

}  // namespace sph
