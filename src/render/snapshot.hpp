// What a particle system has drawn, kept: so that it can go on while its picture is made.
#pragma once

#include <cstddef>
#include <vector>

#include "particles/canvas.hpp"

namespace sph {

/// A canvas that notes what is drawn on it, number for number, to draw it again later on another one. Its memory is
/// kept from one picture to the next.
class Snapshot final : public Canvas {
 public:
  /// Forgets what was drawn; what comes next is to show this quantity.
  void Begin(Colouring colouring);

  Colouring WantedColouring() const override { return colouring_; }
  void DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                 std::span<const double> values) override;
  void DrawWall(Vec2 a, Vec2 b) override;

  /// Calls on `canvas` what was called here, in that order but for the walls, which come after the disks. The colouring
  /// that `canvas` wants must be that of Begin.
  void DrawOn(Canvas& canvas) const;

 private:
  /// The disks of one call: `count` of x_ and y_ from `first` on, of values_ from first_value on.
  struct Disks {
    std::size_t first = 0;
    std::size_t count = 0;
    double radius = 0;
    std::size_t first_value = 0;
    std::size_t values = 0;  // count or 0
  };
  struct WallSegment {
    Vec2 a, b;
  };

  Colouring colouring_ = Colouring::kBlackDisks;
  std::vector<double> x_, y_, values_;
  std::vector<Disks> disks_;
  std::vector<WallSegment> walls_;
};

}  // namespace sph
