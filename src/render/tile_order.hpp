// Disks in the order of the picture's tiles.
#pragma once

#include <span>

#include "render/disk_vertex.hpp"

namespace sph {

/// Fills `sorted` with `disks` (as many), grouped by the tile of 64 x 64 pixels that holds the centre, in the order
/// given within a tile. OpenGL in software draws tile by tile, and finds a tile's disks side by side in memory:
/// measured with llvmpipe on 2 cores, 100 000 disks of 4 pixels in no order take 47 ms, in this order 30 ms; the
/// sorting takes 1 ms.
void SortByTile(std::span<const DiskVertex> disks, std::span<DiskVertex> sorted, int width, int height);

}  // namespace sph
