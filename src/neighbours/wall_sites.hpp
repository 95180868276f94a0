// Places beyond plane walls for particles that stand for the wall: layers of a lattice, wherever fluid is near.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/images.hpp"

namespace sph {

/// On which side of the fluid something is, in x or in y.
enum class Beyond : std::uint8_t { kNone, kLow, kHigh };

struct WallSite {
  std::int32_t column = 0;  ///< of the lattice, 0 next to the low end in x
  std::int32_t row = 0;
  Beyond in_x = Beyond::kNone;  ///< beyond which walls; in corners there are two
  Beyond in_y = Beyond::kNone;
};

/// The lattice fits between two ends of an axis, so that the first sites are half a spacing beyond walls and the last
/// ones before a period's end are as far from the first ones of the next; where walls have moved it goes with them.
class WallSites {
 public:
  /// Finds every site within `reach` [m] of a particle, and a few more, beyond those of the ends that are walls.
  /// Particles may be anywhere, or nowhere (not a number). Nothing where ends.site_spacing is 0.
  void Find(const Ends& ends, double reach, std::span<const double> x, std::span<const double> y);
  /// Site k becomes the former site order[k].
  void Reorder(std::span<const std::uint32_t> order);
  /// Where they are with these ends, which may have moved a little [m]; appended.
  void Place(const Ends& ends, std::vector<double>& x, std::vector<double>& y) const;

  void Transfer(Archive& archive);

  std::size_t Size() const { return sites_.size(); }
  std::span<const WallSite> Sites() const { return sites_; }
  std::size_t Bytes() const;

 private:
  std::vector<WallSite> sites_, scratch_;
  std::int32_t columns_ = 0, rows_ = 0;  // between the ends; 0 where there are not two
};

}  // namespace sph
