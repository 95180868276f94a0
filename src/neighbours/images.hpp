// Periodic boundaries and plane walls as mirrors: copies of the particles near a side, seen beyond it.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/archive.hpp"
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

/// What bounds one coordinate.
struct AxisEnds {
  double low = -std::numeric_limits<double>::infinity();  ///< [m]; finite where something is there
  double high = std::numeric_limits<double>::infinity();
  bool periodic = false;  ///< else what is finite is a mirror
  friend bool operator==(const AxisEnds&, const AxisEnds&) = default;
};
struct Ends {
  AxisEnds x, y;
  /// 0: what is finite and not periodic is a mirror; else particles stand there, about so far apart [m].
  double site_spacing = 0;

  bool Any() const { return !(*this == Ends{}); }
  /// What has images.
  Ends WithImages() const;
  friend bool operator==(const Ends&, const Ends&) = default;
};

/// How one coordinate of an image comes from its source's.
enum class ImageOf : std::uint8_t { kSame, kPeriodUp, kPeriodDown, kMirrorLow, kMirrorHigh };
inline bool Mirrored(ImageOf image) { return image == ImageOf::kMirrorLow || image == ImageOf::kMirrorHigh; }

/// Copies of particles: image k is of particle Sources()[k].
class Images {
 public:
  /// Finds every image that is within `support` [m] of a particle, or will be before particles have travelled further
  /// than `travel` [m]. Particles may have drifted beyond the ends, but not far. Precondition: periodic ends are more
  /// than twice the support apart.
  void Find(const Ends& ends, double support, double travel, std::span<const double> x, std::span<const double> y);
  /// Image k becomes the former image order[k].
  void Reorder(std::span<const std::uint32_t> order);
  /// Where the images of these particles are with these ends, which may have moved a little [m]; overwritten.
  void Place(const Ends& ends, std::span<const double> x, std::span<const double> y, std::vector<double>& image_x,
             std::vector<double>& image_y) const;

  /// What Find has found among `particles` particles.
  void Transfer(Archive& archive, std::size_t particles);

  std::size_t Size() const { return sources_.size(); }
  std::span<const std::uint32_t> Sources() const { return sources_; }
  std::span<const ImageOf> InX() const { return in_x_; }
  std::span<const ImageOf> InY() const { return in_y_; }
  std::size_t Bytes() const;

 private:
  std::vector<std::uint32_t> sources_, sources_scratch_;
  std::vector<ImageOf> in_x_, in_y_, scratch_;
};

}  // namespace sph
