// The area that the particles of a liquid fill, whatever their densities say.
#pragma once

#include <optional>
#include <span>

#include "base/vec2.hpp"

namespace sph {

struct FilledShape {
  double area = 0;  ///< [m^2]
  double edge = 0;  ///< length of its free edge [m]
};

/// The disks around the points, their radius being one spacing, after half a spacing was taken off their edge again:
/// holes narrower than two spacings are closed, and a flat edge ends half a spacing beyond the outermost particles,
/// where a lattice of such particles ends. (Closing and erosion of mathematical morphology [J. Serra, Image Analysis
/// and Mathematical Morphology, 1982, ch. II], on cells of a sixth of a spacing.) The edge's length is what was taken
/// off over half a spacing. What lies outside `bounds` is not counted, and the
/// liquid has no edge there. Nothing if the points are strewn too far to be looked at.
std::optional<FilledShape> FilledShapeOf(std::span<const Vec2> points, double spacing, const Box& bounds);

}  // namespace sph
