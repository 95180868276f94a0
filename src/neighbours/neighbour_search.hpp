// Keeps clusters and their lists fit for particles that move: lists that look ahead, made anew only when a particle has
// left the course that they foresaw.
#pragma once

#include <span>
#include <vector>

#include "neighbours/cluster_boxes.hpp"
#include "neighbours/cluster_courses.hpp"
#include "neighbours/cluster_lists.hpp"
#include "neighbours/cluster_order.hpp"
#include "neighbours/images.hpp"
#include "neighbours/wall_sites.hpp"

namespace sph {

/// What to do before the next passes.
enum class SearchTask {
  kNothing,  ///< the lists hold everything within reach, if all have kept to their courses
  kLists,    ///< find the neighbours again
  kSort,     ///< put the particles in order first: Sort, reorder, then find
};

class NeighbourSearch {
 public:
  /// Forgets everything: the next task is kSort.
  void Invalidate() { sorted_ = false; }

  /// Whether lists are kept for several steps, which is the default; else they are made anew at every one.
  void KeepLists(bool keep) { keep_lists_ = keep; }

  /// How many threads share the work of Prepare; one unless told.
  void UseThreads(int threads) { threads_ = threads; }

  /// What bounds the particles; nothing unless told. Images and wall particles are found with the lists.
  void SetEnds(const Ends& ends) { ends_ = ends; }
  const Ends& CurrentEnds() const { return ends_; }
  const Images& AllImages() const { return images_; }
  const WallSites& AllWallSites() const { return wall_sites_; }
  /// How many there are of both; they are numbered after the particles, images first.
  std::size_t Extras() const { return images_.Size() + wall_sites_.Size(); }
  /// Where they are with these ends, which may have moved a little [m]; overwritten.
  void PlaceExtras(const Ends& ends, std::span<const double> x, std::span<const double> y, std::vector<double>& extra_x,
                   std::vector<double>& extra_y) const;

  /// @param time     now [s]
  /// @param support  reach of the kernel [m]
  SearchTask NextTask(double time, double support);
  /// Whether all have kept to their courses until now, where these are their positions. If not, the task is kLists.
  template <typename Real>
  bool Hold(const Positions<Real>& positions, double time) {
    return courses_.Hold(Clusters(), boxes_, positions, support_, time, threads_);
  }

  /// First part of kSort: columns and order for particles about `spacing` [m] apart. The caller reorders its arrays by
  /// Order().
  void Sort(std::span<const double> x, std::span<const double> y, double spacing, int lanes);
  std::span<const std::uint32_t> Order() const { return order_.Order(); }
  /// Second part, with the reordered positions.
  void Cut(std::span<const double> x, std::span<const double> y);

  /// Finds out where the clusters are. Whether they are compact enough for lists; else the task is kSort, after which
  /// they are.
  bool AreCompact(std::span<const double> x, std::span<const double> y);
  /// Courses and empty blocks for lists of compact clusters; then FindNeighbours is to be called with CurrentReach()
  /// for every block, those of the wall particles, too, and Finish.
  /// @param least_horizon  lists shall hold for so long before and after `now` [s]
  /// @param ends_travel  how far images and wall particles may get until then by the motion of walls [m]
  void Prepare(const Movement& now, double least_horizon = 0, double ends_travel = 0);
  ListReach CurrentReach() const { return {support_, courses_.Horizon(), greatest_travel_}; }
  void Finish();

  /// The lists of these particles and all that they depend on. Read where a register has another number of `lanes` than
  /// where they were written, they are of no use: then the next task is kSort.
  void Transfer(Archive& archive, std::size_t particles, int lanes);

  std::span<const Cluster> Clusters() const { return order_.Clusters(); }
  const ClusterBoxes& Boxes() const { return boxes_; }
  /// Particles, images and wall particles.
  ClusterSets Sets() const;
  std::vector<ListBlock>& Blocks() { return blocks_; }
  std::span<const ListBlock> Blocks() const { return blocks_; }
  /// The lists of the wall particles.
  std::vector<ListBlock>& WallBlocks() { return wall_blocks_; }
  std::span<const ListBlock> WallBlocks() const { return wall_blocks_; }
  double Horizon() const { return courses_.Horizon(); }  ///< [s]
  long ListsMade() const { return lists_made_; }
  long Sorts() const { return sorts_; }
  std::size_t Bytes() const;

 private:
  /// Images or wall particles as clusters.
  struct Extra {
    std::vector<double> x, y;  // [m]
    ClusterOrder order;
    ClusterBoxes boxes;
    std::vector<ClusterCourse> courses;
  };
  /// Puts them in order; place() says where they are, reorder(order) changes their order.
  template <typename Place, typename Reorder>
  void Arrange(Extra& extra, Place place, Reorder reorder);
  void FindExtras(std::span<const double> x, std::span<const double> y, double ends_travel);
  void SetImagesOnCourse(double ends_travel);
  void EmptyBlocks(std::vector<ListBlock>& blocks, std::size_t clusters) const;

  ClusterOrder order_;
  ClusterBoxes boxes_;
  ClusterCourses courses_;
  Ends ends_;
  Images images_;
  WallSites wall_sites_;
  Extra image_clusters_, wall_clusters_;
  std::vector<ListBlock> blocks_, wall_blocks_;
  bool sorted_ = false;
  bool just_sorted_ = false;
  bool keep_lists_ = true;
  int threads_ = 1;
  int lanes_ = 0;
  double spacing_ = 0;  // as told for the last sort [m]
  double support_ = 0;
  double greatest_travel_ = 0;  // of anything until the horizon [m]
  std::size_t pairs_ = 0;       // entries of all lists
  double pairs_per_area_ = 0;   // entries over the mean of (reach/support)^2: now, and just after the last sort
  double pairs_per_area_when_sorted_ = 0;
  long lists_made_ = 0;
  long sorts_ = 0;
};

}  // namespace sph
