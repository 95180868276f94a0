#include "render/tile_order.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/check.hpp"

namespace sph {
namespace {

constexpr int kTile = 64;  // [pixels], llvmpipe's

/// The tile of a coordinate measured from the middle of a side of `size` pixels; of the nearest one if it is outside.
std::size_t TileOf(float coordinate, int size) {
  const float pixel = coordinate + 0.5F * static_cast<float>(size);
  return static_cast<std::size_t>(std::clamp(pixel, 0.0F, static_cast<float>(size - 1))) / kTile;
}

}  // namespace

void SortByTile(std::span<const DiskVertex> disks, std::span<DiskVertex> sorted, int width, int height) {
  SPH_CHECK(disks.size() == sorted.size(), "{} disks, room for {}", disks.size(), sorted.size());
  const std::size_t columns = static_cast<std::size_t>(width) / kTile + 1;
  const std::size_t rows = static_cast<std::size_t>(height) / kTile + 1;
  const auto tile = [&](const DiskVertex& disk) { return TileOf(disk.y, height) * columns + TileOf(disk.x, width); };

  // A counting sort: starts[k] is where the next disk of tile k goes.
  std::vector<std::size_t> starts(columns * rows + 1, 0);
  for (const DiskVertex& disk : disks) ++starts[tile(disk) + 1];
  for (std::size_t k = 1; k < starts.size(); ++k) starts[k] += starts[k - 1];
  for (const DiskVertex& disk : disks) sorted[starts[tile(disk)]++] = disk;
}

}  // namespace sph
