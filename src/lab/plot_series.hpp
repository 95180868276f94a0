// What a plot shows inside its frame: map, bands, lines, markers.
#pragma once

#include "lab/plot_layout.hpp"
#include "lab/plot_surface.hpp"

namespace sph {

void DrawMap(Surface& surface, const PlotLayout& layout, const HeatMap& map);
/// Bands and series, in the plot's order.
void DrawSeries(Surface& surface, const PlotLayout& layout, const Plot& plot);

/// For series and legend: the line's pattern and width as the next stroke's, and one marker. `series` is Styled.
void SetLine(Surface& surface, const Series& series, double unit);
void DrawMarker(Surface& surface, Marker marker, Vec2 at, double size);

}  // namespace sph
