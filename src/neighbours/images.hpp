// Periodic boundaries: copies of the particles near one side, seen beyond the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace sph {

/// What repeats: everything at x stands for all x + k (x1 - x0), k whole, where the box is periodic in x; the same in
/// y.
struct Periods {
  Box box;  ///< [m]
  bool in_x = false;
  bool in_y = false;

  bool Any() const { return in_x || in_y; }
  /// The point that stands for `point` in the box.
  Vec2 Wrap(Vec2 point) const;
  friend bool operator==(const Periods&, const Periods&) = default;
};

/// Image k of particle Sources()[k] is at its position plus (ShiftX()[k], ShiftY()[k]) [m].
class Images {
 public:
  /// Finds every image within `reach` [m] of a particle. Particles may have drifted out of the box, but not far.
  /// Precondition: the box is longer than twice the reach where it is periodic.
  void Find(const Periods& periods, double reach, std::span<const double> x, std::span<const double> y);
  /// Image k becomes the former image order[k].
  void Reorder(std::span<const std::uint32_t> order);

  std::size_t Size() const { return sources_.size(); }
  std::span<const std::uint32_t> Sources() const { return sources_; }
  std::span<const double> ShiftX() const { return shift_x_; }
  std::span<const double> ShiftY() const { return shift_y_; }
  std::size_t Bytes() const;

 private:
  std::vector<std::uint32_t> sources_, sources_scratch_;
  std::vector<double> shift_x_, shift_y_, scratch_;
};

}  // namespace sph
