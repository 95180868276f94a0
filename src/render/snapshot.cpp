#include "render/snapshot.hpp"

#include "base/check.hpp"

namespace sph {

void Snapshot::Begin(Colouring colouring) {
  colouring_ = colouring;
  x_.clear();
  y_.clear();
  values_.clear();
  disks_.clear();
  walls_.clear();
}

void Snapshot::DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                         std::span<const double> values) {
  SPH_CHECK(x.size() == y.size(), "{} x, {} y", x.size(), y.size());
  SPH_CHECK(values.empty() || values.size() == x.size(), "{} values of {} disks", values.size(), x.size());
  disks_.push_back({x_.size(), x.size(), radius, values_.size(), values.size()});
  x_.insert(x_.end(), x.begin(), x.end());
  y_.insert(y_.end(), y.begin(), y.end());
  values_.insert(values_.end(), values.begin(), values.end());
}

void Snapshot::DrawWall(Vec2 a, Vec2 b) { walls_.push_back({a, b}); }

void Snapshot::DrawOn(Canvas& canvas) const {
  SPH_CHECK(canvas.WantedColouring() == colouring_, "colouring {}, wanted {}", static_cast<int>(colouring_),
            static_cast<int>(canvas.WantedColouring()));
  const std::span<const double> x = x_, y = y_, values = values_;
  for (const Disks& disks : disks_) {
    canvas.DrawDisks(x.subspan(disks.first, disks.count), y.subspan(disks.first, disks.count), disks.radius,
                     values.subspan(disks.first_value, disks.values));
  }
  for (const WallSegment& wall : walls_) canvas.DrawWall(wall.a, wall.b);
}

}  // namespace sph
