// Where the particles of a block of fluid start: at random, or on a lattice.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "base/vec2.hpp"

namespace sph {

/// A box, or a disk when `radius` > 0.
struct Region {
  Box box;
  Vec2 centre;
  double radius = 0;

  double Area() const;  ///< [m^2]
  Box Bounds() const;
  bool Contains(Vec2 point) const;
};

enum class Arrangement {
  kRandom,     ///< independent, uniform over the region (the paper's starts)
  kLattice,    ///< square lattice, rows from the bottom up
  kJittered,   ///< the lattice, each particle moved to the right by up to `jitter` (the tutorial's dam)
  kPerturbed,  ///< the lattice, each particle moved by up to `jitter` in both directions, either way
  kHexagonal,  ///< hexagonal lattice, as many particles per area
  kRelaxed,    ///< random, but as even as a lattice: see FindStart in scenes/start.hpp; Place itself has it random
};

/// A block of fluid to be placed.
struct Block {
  std::size_t particles = 0;
  Region region;
  Arrangement arrange = Arrangement::kRandom;
  double spacing = 0;  ///< of the lattice [m]; 0: the square root of region area over particles
  double jitter = 0;   ///< [m]
  Vec2 velocity;       ///< of every particle [m/s]
  /// Of a lattice that fills its box from side to side, see Fitted; 0 of any other start.
  std::size_t columns = 0, rows = 0;

  bool IsDisk() const { return region.radius > 0; }
  bool IsLattice() const { return arrange != Arrangement::kRandom && arrange != Arrangement::kRelaxed; }
};

/// Side of the square that one particle of the block fills [m].
double Spacing(const Block& block);

/// The block with the number of particles that Place makes of it. A lattice without a spacing of its own is stretched a
/// little, so that whole numbers of columns and rows fill its box: of those whose product is within half a row or half
/// a column of the number asked for, the pair with the nearest product and the squarest cells. In a disk the lattice
/// has a site in the centre, and the number is the nearest n of which the disk holds exactly n at an n-th of its area
/// each. A lattice with a spacing of its own keeps it, and ends where a disk does.
Block Fitted(const Block& block);

/// The numbers nearest to block.particles, below and above, whose lattice fills the region without being stretched; 0
/// where there is none within a factor of 2.
std::pair<std::size_t, std::size_t> FillingNumbers(const Block& block);

/// The box that no particle of a fitted block starts outside of [m].
Box StartBounds(const Block& block);

/// The block's positions [m], block.particles of them. A lattice with a spacing of its own fills a box row by row from
/// the bottom, and goes on above it when its rows do not hold them all; in a disk, lattices end where the disk does, so
/// that the result may be shorter, unless the block is fitted.
std::vector<Vec2> Place(const Block& block, Random& random);

/// Positions for a block dropped into a scene that may have fluid in the way: lattice rows from the bottom of the
/// block's region up to the top of `room`, leaving out sites for which `occupied` is true; if there is no room for the
/// whole block, the same beside it, to the right and to the left in turn, as far as `room` goes. Empty if there is no
/// room at all.
std::vector<Vec2> PlaceAround(const Block& block, const Box& room, const std::function<bool(Vec2)>& occupied);

}  // namespace sph
