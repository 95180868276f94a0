// Courses of clusters, checked on vectors; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "neighbours/cluster_courses.cpp"
#include "neighbours/cluster_courses.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <algorithm>
#include <atomic>

#include "base/memory.hpp"
#include "base/shared_work.hpp"
#include "neighbours/coordinates-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE auto LoadStarts(hn::ScalableTag<float> d, const float* start) { return hn::LoadU(d, start); }
HWY_INLINE auto LoadStarts(hn::ScalableTag<double> d, const float* start) {
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, decltype(d)>(), start));
}

/// How far particles of the clusters first ... last - 1 are from their courses at most [m].
template <typename Real>
void Strays(const ClusterVoyage& voyage, const Positions<Real>& positions, std::size_t first, std::size_t last,
            float* strayed) {
  const hn::ScalableTag<Real> d;
  const double unit = Positions<Real>::Unit(voyage.support), per_unit = 1 / unit;
  const auto in_supports = hn::Set(d, static_cast<Real>(unit / voyage.support));
  for (std::size_t k = first; k < last; ++k) {
    const Cluster& cluster = voyage.clusters[k];
    const auto apart = [&](const auto* now, double middle, float velocity, const float* start) HWY_ATTR {
      const double middle_now = middle + voyage.elapsed * static_cast<double>(velocity);
      const auto x = LoadCoordinates(d, now + cluster.first);
      const auto from_middle = Difference(d, x, Positions<Real>::ToCoordinate(middle_now, per_unit));
      return hn::MulSub(from_middle, in_supports, LoadStarts(d, start + cluster.first));
    };
    const Vec2 middle = voyage.boxes->Of(k).Centre();
    const auto x = apart(positions.X(), middle.x, voyage.courses[k].vx, voyage.start_x);
    const auto y = apart(positions.Y(), middle.y, voyage.courses[k].vy, voyage.start_y);
    const auto square = hn::IfThenElseZero(hn::FirstN(d, cluster.count), hn::MulAdd(x, x, hn::Mul(y, y)));
    const auto greatest = static_cast<double>(hn::GetLane(hn::MaxOfLanes(d, square)));
    strayed[k] = static_cast<float>(voyage.support * std::sqrt(greatest));
  }
}

}  // namespace

void StraysInFloat(const ClusterVoyage& voyage, const Positions<float>& positions, std::size_t first, std::size_t last,
                   float* strayed) {
  Strays<float>(voyage, positions, first, last, strayed);
}
void StraysInDouble(const ClusterVoyage& voyage, const Positions<double>& positions, std::size_t first,
                    std::size_t last, float* strayed) {
  Strays<double>(voyage, positions, first, last, strayed);
}

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sph {
namespace {

// In supports. Where one particle is fast, all clusters look further around themselves.
constexpr double kFurthestTravel = 0.5;
// In steps.
constexpr double kFurthestHorizon = 100;
// Particles are expected to stray as their velocities say, or as they did before, but times the first and by the
// second, in supports; and no further than the third.
constexpr double kMargin = 1.3;
constexpr double kLeastStray = 0.005;
constexpr double kMostStray = 0.5;

/// Calls work(first, last) for pieces first ... last - 1 of the clusters.
template <typename Work>
void ForPieces(std::size_t clusters, int threads, Work work) {
  constexpr std::size_t kClustersAtATime = 64;
  constexpr std::size_t kClustersOfOneThread = 512;  // waking the others costs more than so little work
  const std::size_t pieces = (clusters + kClustersAtATime - 1) / kClustersAtATime;
  ShareOut(pieces, clusters > kClustersOfOneThread ? threads : 1, [&](std::size_t piece) {
    work(piece * kClustersAtATime, std::min((piece + 1) * kClustersAtATime, clusters));
  });
}

/// The mean velocity, and how fast particles leave that course [m/s] in place of how far.
ClusterCourse CourseOf(const Cluster& cluster, const Movement& now) {
  const std::uint32_t last = cluster.first + cluster.count;
  Vec2 mean;
  for (std::uint32_t i = cluster.first; i < last; ++i) mean = mean + Vec2{now.vx[i], now.vy[i]};
  mean = 1.0 / cluster.count * mean;
  double apart2 = 0, push2 = 0;
  for (std::uint32_t i = cluster.first; i < last; ++i) {
    const Vec2 velocity{now.vx[i], now.vy[i]};
    const Vec2 apart = velocity - mean, push = velocity - Vec2{now.vx_prev[i], now.vy_prev[i]};
    apart2 = std::max(apart2, Dot(apart, apart));
    push2 = std::max(push2, Dot(push, push));
  }
  const double unrest = std::sqrt(apart2) + std::sqrt(push2);
  return {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(unrest)};
}

/// The horizon H that costs least [s]. With lists of reach R + s passes take longer in proportion to 1 + 1.1 s/R (the
/// area within reach of a square cluster of 16 particles); two clusters beside each other close in at 4 times their
/// unrest u, of which they allow for more than half, so s = 4 u H; making the lists, every H, costs 0.28 of the passes
/// of a step dt. The least of 1.1 s/R + 0.28 dt/H is at H^2 = 0.064 R dt/u.
double BestHorizon(double unrest, double fastest, double support, double step) {
  const double best = std::sqrt(0.064 * support * step / unrest);
  const double horizon = std::min({best, kFurthestTravel * support / fastest, kFurthestHorizon * step});
  return horizon >= 1.5 * step ? horizon : 0;
}

}  // namespace

HWY_EXPORT(StraysInFloat);
HWY_EXPORT(StraysInDouble);

void ClusterCourses::SetOut(std::span<const Cluster> clusters, const ClusterBoxes& boxes, const Movement& now,
                            double support, bool keep, double least_horizon, bool known, int threads) {
  const double before = looked_ - set_out_;  // [s]
  const auto resize = [](auto& values, std::size_t size) {
    MakeRoom(values, size);
    values.resize(size);
  };
  resize(courses_, clusters.size()), resize(strayed_, clusters.size());
  resize(start_x_, now.x.size() + kPadding), resize(start_y_, now.x.size() + kPadding);
  ForPieces(clusters.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      courses_[k] = CourseOf(clusters[k], now);
      const Vec2 middle = boxes.Of(k).Centre();
      for (std::uint32_t i = clusters[k].first; i < clusters[k].first + clusters[k].count; ++i) {
        start_x_[i] = static_cast<float>((now.x[i] - middle.x) * (1 / support));
        start_y_[i] = static_cast<float>((now.y[i] - middle.y) * (1 / support));
      }
    }
  });
  double roots = 0, fastest = 0;  // roots, so that a few wild clusters do not decide for all
  for (const ClusterCourse& course : courses_) {
    roots += std::sqrt(static_cast<double>(course.stray));
    fastest = std::max(fastest, TravelOf(course, 1));
  }
  const double root = roots / static_cast<double>(clusters.size());
  horizon_ = std::max(keep ? BestHorizon(root * root, fastest, support, now.step) : 0,
                      std::min(least_horizon, support / fastest));
  // What they strayed beside their velocities is no steady drift: it grows like a random walk.
  const double longer = known && before > 0 ? std::sqrt(horizon_ / before) : 0;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const double expected =
        std::max(horizon_ * static_cast<double>(courses_[k].stray), longer * static_cast<double>(strayed_[k]));
    const double granted = std::min(kMargin * expected + kLeastStray * support, kMostStray * support);
    courses_[k].stray = horizon_ > 0 ? static_cast<float>(granted) : 0;
  }
  set_out_ = looked_ = now.time;
}

template <typename Real>
bool ClusterCourses::Hold(std::span<const Cluster> clusters, const ClusterBoxes& boxes,
                          const Positions<Real>& positions, double support, double time, int threads) {
  looked_ = time;
  const ClusterVoyage voyage{clusters, &boxes, courses_, start_x_.data(), start_y_.data(), time - set_out_, support};
  std::atomic<bool> hold = true;
  ForPieces(clusters.size(), threads, [&](std::size_t first, std::size_t last) {
    if constexpr (std::is_same_v<Real, float>) {
      HWY_DYNAMIC_DISPATCH(StraysInFloat)(voyage, positions, first, last, strayed_.data());
    } else {
      HWY_DYNAMIC_DISPATCH(StraysInDouble)(voyage, positions, first, last, strayed_.data());
    }
    for (std::size_t k = first; k < last; ++k) {
      if (!(strayed_[k] <= courses_[k].stray)) hold.store(false, std::memory_order_relaxed);
    }
  });
  return hold;
}
template bool ClusterCourses::Hold(std::span<const Cluster>, const ClusterBoxes&, const Positions<float>&, double,
                                   double, int);
template bool ClusterCourses::Hold(std::span<const Cluster>, const ClusterBoxes&, const Positions<double>&, double,
                                   double, int);

void ClusterCourses::Transfer(Archive& archive, std::size_t clusters, std::size_t particles) {
  std::vector<float> numbers;
  for (const ClusterCourse& course : courses_) numbers.insert(numbers.end(), {course.vx, course.vy, course.stray});
  archive(set_out_, looked_, horizon_, numbers, strayed_, start_x_, start_y_);
  if (!archive.Reading()) return;
  Archive::Require(numbers.size() == 3 * clusters && strayed_.size() == clusters);
  Archive::Require(start_x_.size() == particles + kPadding && start_y_.size() == start_x_.size());
  courses_.clear();
  for (std::size_t k = 0; k < numbers.size(); k += 3) courses_.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
}

std::size_t ClusterCourses::Bytes() const {
  return sizeof(ClusterCourse) * courses_.capacity() +
         sizeof(float) * (strayed_.capacity() + start_x_.capacity() + start_y_.capacity());
}

}  // namespace sph
#endif  // HWY_ONCE
