// What the graphics card is told of a disk.
#pragma once

#include "render/colour_map.hpp"

namespace sph {

struct DiskVertex {
  float x =
      0;  // [pixels] from the middle of the window, so that little precision is lost however far off the origin is
  float y = 0;  // [pixels] upwards
  Rgb colour;
  friend bool operator==(const DiskVertex&, const DiskVertex&) = default;
};

}  // namespace sph
