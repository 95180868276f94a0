// The legend: every named series and band, where it hides the least.
#pragma once

#include "lab/plot_layout.hpp"
#include "lab/plot_surface.hpp"

namespace sph {

/// [pixels]; {0, 0} if nothing has a name.
Vec2 LegendSize(const Plot& plot, double unit);

struct LegendPlace {
  Box box;         // [pixels]
  double ink = 0;  // mean opacity of what lies under it
};
/// The place in the frame with the least ink of `data`: a corner, else the middle of an edge.
LegendPlace EmptiestPlace(Surface& data, const Box& frame, Vec2 size, double unit);

void DrawLegend(Surface& surface, const Plot& plot, const Box& box, double unit);

}  // namespace sph
