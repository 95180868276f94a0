#include "lab/plot_legend.hpp"

#include <algorithm>
#include <cmath>

#include "lab/plot_series.hpp"
#include "lab/plot_style.hpp"

namespace sph {
namespace {

// [pixels of a plot of 1200 x 800]
constexpr double kSample = 56;  // width of the line or patch beside the name
constexpr double kLegendPadding = 12;
constexpr double kDistance = 18;  // from the frame

void DrawSample(Surface& surface, const Series& series, double left, double y, double unit) {
  Series bold = series;
  bold.opacity = 1;
  bold.marker_size = std::max(series.marker_size, 12.0);
  cairo_t* context = surface.Context();
  if (bold.line != Line::kNone) {
    SetLine(surface, bold, unit);
    cairo_move_to(context, left, y);
    cairo_line_to(context, left + kSample * unit, y);
    cairo_stroke(context);
  }
  surface.SetColour(*bold.colour);
  DrawMarker(surface, bold.marker, {left + 0.5 * kSample * unit, y}, bold.marker_size * unit);
}

}  // namespace

Vec2 LegendSize(const Plot& plot, double unit) {
  double widest = 0;
  int entries = 0;
  const auto add = [&](const std::string& name) {
    if (name.empty()) return;
    widest = std::max(widest, WidthOfText(name, kLegendSize * unit));
    ++entries;
  };
  for (const Series& series : plot.series) add(series.name);
  for (const Band& band : plot.bands) add(band.name);
  if (entries == 0) return {};
  return {widest + (kSample + 3 * kLegendPadding) * unit,
          entries * LineHeight(kLegendSize * unit) + kLegendPadding * unit};
}

LegendPlace EmptiestPlace(Surface& data, const Box& frame, Vec2 size, double unit) {
  const double d = kDistance * unit;
  const double left = frame.x0 + d, right = frame.x1 - d - size.x, centre = 0.5 * (left + right);
  const double top = frame.y0 + d, bottom = frame.y1 - d - size.y, middle = 0.5 * (top + bottom);
  LegendPlace best{{}, 2};
  for (const Vec2 at : {Vec2{right, top}, Vec2{left, top}, Vec2{right, bottom}, Vec2{left, bottom}, Vec2{centre, top},
                        Vec2{centre, bottom}, Vec2{right, middle}, Vec2{left, middle}}) {
    const Box box = {at.x, at.y, at.x + size.x, at.y + size.y};
    const bool inside = at.x >= left && at.y >= top;
    const double ink = inside ? data.Ink({box.x0 - d / 2, box.y0 - d / 2, box.x1 + d / 2, box.y1 + d / 2}) : 1;
    if (ink < best.ink) best = {box, ink};
  }
  return best;
}

void DrawLegend(Surface& surface, const Plot& plot, const Box& box, double unit) {
  surface.SetColour(kMajorGrid);
  const double border = std::max(1.0, std::round(unit));
  surface.FillBox({std::round(box.x0) - border, std::round(box.y0) - border, std::round(box.x1) + border,
                   std::round(box.y1) + border});
  surface.SetColour(kWhite);
  surface.FillBox({std::round(box.x0), std::round(box.y0), std::round(box.x1), std::round(box.y1)});
  const double size = kLegendSize * unit, left = box.x0 + kLegendPadding * unit;
  double y = box.y0 + 0.5 * (kLegendPadding * unit + LineHeight(size));
  const auto name = [&](const std::string& text) {
    surface.SetColour(kInk);
    DrawText(surface, text, {left + (kSample + kLegendPadding) * unit, y}, size, Anchor::kLeft);
    y += LineHeight(size);
  };
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    if (plot.series[i].name.empty()) continue;
    if (plot.map) {  // on which a white line can be seen
      surface.SetColour(MapColour(0.4));
      surface.FillBox({left, y - 0.4 * size, left + kSample * unit, y + 0.4 * size});
    }
    DrawSample(surface, Styled(plot, i), left, y, unit);
    name(plot.series[i].name);
  }
  for (const Band& band : plot.bands) {
    if (band.name.empty()) continue;
    surface.SetColour(ColourOf(band), band.opacity);
    surface.FillBox({left, y - 0.4 * size, left + kSample * unit, y + 0.4 * size});
    name(band.name);
  }
}

}  // namespace sph
