// The sites of lattices: which of them are inside a region, and in which order they are taken.
#pragma once

#include <limits>

#include "particles/placement.hpp"

namespace sph {

/// Sites in columns and rows, every other row half a pitch to the right where it is hexagonal.
struct Lattice {
  Vec2 origin;  ///< [m]
  Vec2 pitch;   ///< from column to column, from row to row [m]
  Vec2 margin;  ///< from the origin to the first site, in pitches
  bool hexagonal = false;

  double Shift(long row) const { return margin.x + (hexagonal && row % 2 != 0 ? 0.5 : 0); }
  Vec2 Site(long column, long row) const {
    return origin +
           Vec2{(static_cast<double>(column) + Shift(row)) * pitch.x, (static_cast<double>(row) + margin.y) * pitch.y};
  }
};

/// The first and the last column or row; none if the last is before the first.
struct Run {
  long first = 0, last = -1;
};

/// From column to column and from row to row [m], one particle to the square of the spacing; rows of hexagons are
/// sqrt(3)/2 of the distance in a row apart.
Vec2 PitchOf(const Block& block);

/// The lattice of a block that is fitted to its box, of hexagons, or of a disk, in whose centre it has a site.
Lattice LatticeInside(const Block& block);
/// The rows of that lattice, some of which may have no site inside.
Run RowsInside(const Block& block, const Lattice& lattice);
/// The columns of a row whose sites the region contains.
Run ColumnsInside(const Block& block, const Lattice& lattice, long row);
std::size_t SitesInside(const Block& block);

/// How many columns of that width a box has, those included that rounding makes a little too wide.
struct Columns {
  long count = 1;
  double margin = 0.5;  ///< to the middle of the first one, in columns
};
Columns ColumnsOf(const Box& box, double spacing);

/// Whether the block's lattice begins at the bottom of its region and keeps its spacing: a square one with a spacing of
/// its own, or one that is not fitted to its box.
bool StartsAtTheBottom(const Block& block);

/// Calls visit(site) for the sites inside, rows from the bottom up, until it returns false.
template <typename Visit>
void VisitSitesInside(const Block& block, Visit visit) {
  const Lattice lattice = LatticeInside(block);
  const Run rows = RowsInside(block, lattice);
  for (long row = rows.first; row <= rows.last; ++row) {
    const Run columns = ColumnsInside(block, lattice, row);
    for (long column = columns.first; column <= columns.last; ++column) {
      if (!visit(lattice.Site(column, row))) return;
    }
  }
}

/// Calls visit(site) for the sites of a square lattice, half a spacing inside `box`, rows from the bottom up, until it
/// returns false. A box narrower than a spacing has one column in its middle.
template <typename Visit>
void VisitLattice(const Box& box, double spacing, Visit visit) {
  constexpr double kRoundOff = 1e-9;
  const Columns columns = ColumnsOf(box, spacing);
  for (long row = 0; box.y0 + static_cast<double>(row + 1) * spacing <= box.y1 + kRoundOff * spacing; ++row) {
    for (long column = 0; column < columns.count; ++column) {
      const Vec2 site{box.x0 + (static_cast<double>(column) + columns.margin) * spacing,
                      box.y0 + (static_cast<double>(row) + 0.5) * spacing};
      if (!visit(site)) return;
    }
  }
}

/// Calls visit(site) for the sites of the block's lattice, beyond the top of its box if need be.
template <typename Visit>
void VisitSites(const Block& block, Visit visit) {
  if (!StartsAtTheBottom(block)) return VisitSitesInside(block, visit);
  Box column = block.region.Bounds();
  if (!block.IsDisk()) column.y1 = std::numeric_limits<double>::max();
  VisitLattice(column, Spacing(block),
               [&](Vec2 site) { return block.IsDisk() && !block.region.Contains(site) ? true : visit(site); });
}

}  // namespace sph
