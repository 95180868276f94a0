// Where clusters are going: their lists reach so far beyond the support that no two particles can come within it unseen
// before the lists are made anew.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "neighbours/cluster_boxes.hpp"
#include "neighbours/positions.hpp"

namespace sph {

/// Particles and how they move. What that foretells need not come true.
struct Movement {
  std::span<const double> x, y;              ///< [m]
  std::span<const double> vx, vy;            ///< [m/s]
  std::span<const double> vx_prev, vy_prev;  ///< half a step ago [m/s]
  double time = 0;                           ///< [s]
  double step = 0;                           ///< length of the last one [s]
};

/// Of a cluster: at any time until the horizon each of its particles is where it was at first, plus velocity times the
/// time since then, but for `stray`.
struct ClusterCourse {
  float vx = 0;  ///< [m/s]
  float vy = 0;
  float stray = 0;  ///< [m]
};

/// How far a particle on that course may get until the horizon [m].
inline double TravelOf(const ClusterCourse& course, double horizon) {
  if (horizon == 0) return static_cast<double>(course.stray);  // of what is infinitely fast, too
  return horizon * static_cast<double>(std::sqrt(course.vx * course.vx + course.vy * course.vy)) +
         static_cast<double>(course.stray);
}
/// How much closer particles on these courses may come to each other [m].
inline double ClosingOf(const ClusterCourse& a, const ClusterCourse& b, double horizon) {
  return TravelOf({a.vx - b.vx, a.vy - b.vy, a.stray + b.stray}, horizon);
}

/// Clusters some time after they set out.
struct ClusterVoyage {
  std::span<const Cluster> clusters;
  const ClusterBoxes* boxes = nullptr;  ///< when they set out
  std::span<const ClusterCourse> courses;
  const float* start_x = nullptr;  ///< of particles, from the middle of their cluster's box [supports]
  const float* start_y = nullptr;
  double elapsed = 0;  ///< [s]
  double support = 0;  ///< [m]
};

class ClusterCourses {
 public:
  /// Courses from here on, until the horizon at which it pays to make the lists anew.
  /// @param keep  whether lists are to hold for several steps
  /// @param least_horizon  [s]
  /// @param known  whether these clusters set out the last time, too: how they strayed then tells how they will now
  void SetOut(std::span<const Cluster> clusters, const ClusterBoxes& boxes, const Movement& now, double support,
              bool keep, double least_horizon, bool known, int threads);

  /// Whether all particles have kept to their courses until `time` [s]; with their positions at that time, and what
  /// SetOut was given.
  template <typename Real>
  bool Hold(std::span<const Cluster> clusters, const ClusterBoxes& boxes, const Positions<Real>& positions,
            double support, double time, int threads);

  double Horizon() const { return horizon_; }  ///< after setting out [s]
  bool Over(double time) const { return time - set_out_ > horizon_; }
  std::span<const ClusterCourse> All() const { return courses_; }

  void Transfer(Archive& archive, std::size_t clusters, std::size_t particles);
  std::size_t Bytes() const;

 private:
  std::vector<ClusterCourse> courses_;    // [clusters]
  std::vector<float> strayed_;            // [clusters]: how far by looked_ [m]
  std::vector<float> start_x_, start_y_;  // [particles + kPadding], see ClusterVoyage
  double set_out_ = 0;                    // [s]
  double looked_ = 0;                     // [s]
  double horizon_ = 0;                    // [s]
};

}  // namespace sph
