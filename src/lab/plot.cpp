#include "lab/plot.hpp"

#include <algorithm>
#include <cmath>

#include "lab/plot_axes.hpp"
#include "lab/plot_layout.hpp"
#include "lab/plot_legend.hpp"
#include "lab/plot_series.hpp"
#include "lab/plot_style.hpp"
#include "lab/plot_surface.hpp"

namespace sph {
namespace {

// [pixels of a plot of 1200 x 800]
constexpr double kHairline = 1;
constexpr double kMajorTick = 8;
constexpr double kMinorTick = 4;
constexpr double kTickLabelGap = 13;

constexpr double kInkUnderLegend = 0.003;   // mean opacity from which on the legend goes beside the plot
constexpr double kLargeLegend = 400 * 200;  // area from which on the sum of the opacity counts, not its mean

void DrawGrid(Surface& surface, const PlotLayout& layout) {
  const Box& f = layout.frame;
  for (const bool major : {false, true}) {
    surface.SetColour(major ? kMajorGrid : kMinorGrid);
    for (const Tick& tick : layout.x_ticks) {
      const double x = layout.x.ToPixel(tick.value);
      if (tick.label.empty() != major) surface.Hairline({x, f.y0}, {x, f.y1}, kHairline * layout.unit);
    }
    for (const Tick& tick : layout.y_ticks) {
      const double y = layout.y.ToPixel(tick.value);
      if (tick.label.empty() != major) surface.Hairline({f.x0, y}, {f.x1, y}, kHairline * layout.unit);
    }
  }
}

void DrawOutline(Surface& surface, const Box& box, double unit) {
  const double width = kHairline * unit;
  surface.SetColour(kInk);
  surface.Hairline({box.x0, box.y0}, {box.x1, box.y0}, width);
  surface.Hairline({box.x0, box.y1}, {box.x1 + std::max(1.0, std::round(width)), box.y1}, width);
  surface.Hairline({box.x0, box.y0}, {box.x0, box.y1}, width);
  surface.Hairline({box.x1, box.y0}, {box.x1, box.y1}, width);
}

double TickLength(const Tick& tick, double unit) { return (tick.label.empty() ? kMinorTick : kMajorTick) * unit; }

void DrawXTicks(Surface& surface, const PlotLayout& layout) {
  const double u = layout.unit, y = layout.frame.y1;
  surface.SetColour(kInk);
  for (const Tick& tick : layout.x_ticks) {
    const double x = layout.x.ToPixel(tick.value);
    surface.Hairline({x, y}, {x, y + TickLength(tick, u)}, kHairline * u);
    DrawText(surface, tick.label, {x, y + (kTickLabelGap + 0.4 * kTickSize) * u}, kTickSize * u, Anchor::kMiddle);
  }
}

/// On the left of `x`, or on its right.
void DrawYTicks(Surface& surface, const std::vector<Tick>& ticks, const AxisMap& axis, double x, double unit,
                bool right) {
  const double side = right ? 1 : -1;
  surface.SetColour(kInk);
  for (const Tick& tick : ticks) {
    const double y = axis.ToPixel(tick.value);
    surface.Hairline({x, y}, {x + side * TickLength(tick, unit), y}, kHairline * unit);
    DrawText(surface, tick.label, {x + side * kTickLabelGap * unit, y}, kTickSize * unit,
             right ? Anchor::kLeft : Anchor::kRight);
  }
}

void DrawBlock(Surface& surface, const TextBlock& block, double x, Anchor anchor) {
  double y = block.top + 0.5 * LineHeight(block.size);
  for (const std::string& line : block.lines) {
    DrawText(surface, line, {x, y}, block.size, anchor);
    y += LineHeight(block.size);
  }
}

void DrawTexts(Surface& surface, const Plot& plot, const PlotLayout& layout) {
  const Vec2 centre = layout.frame.Centre();
  surface.SetColour(kInk);
  DrawBlock(surface, layout.title, 0.5 * surface.Width(), Anchor::kMiddle);
  const double half =
      0.5 * WidthOfText(layout.x_label.lines.empty() ? "" : layout.x_label.lines[0], layout.x_label.size);
  const double room = surface.Width() - half;
  DrawBlock(surface, layout.x_label, std::clamp(centre.x, std::min(half, room), std::max(half, room)), Anchor::kMiddle);
  DrawText(surface, plot.y.label, {layout.y_label_x, centre.y}, layout.y_label_size, Anchor::kMiddle, true);
  surface.SetColour(kFaintInk);
  DrawBlock(surface, layout.note, layout.y_label_x - 0.5 * kLabelSize * layout.unit, Anchor::kLeft);
}

void DrawColourBar(Surface& surface, const HeatMap& map, const PlotLayout& layout) {
  const Box& bar = layout.bar;
  const int rows = static_cast<int>(bar.Height());
  for (int row = 0; row < rows; ++row) {
    surface.SetColour(MapColour((rows - row - 0.5) / rows));
    surface.FillBox({bar.x0, bar.y0 + row, bar.x1, bar.y0 + row + 1});
  }
  DrawOutline(surface, bar, layout.unit);
  DrawYTicks(surface, layout.bar_ticks, layout.bar_values, bar.x1, layout.unit, true);
  DrawText(surface, map.value.label, {layout.bar_label_x, layout.frame.Centre().y}, layout.bar_label_size,
           Anchor::kMiddle, true);
}

/// What the legend must not hide.
Surface DataLayer(const Plot& plot, const PlotLayout& layout, int width, int height) {
  Surface data(width, height);
  if (plot.map) DrawMap(data, layout, *plot.map);
  DrawSeries(data, layout, plot);
  return data;
}

}  // namespace

Image Draw(const Plot& plot, int width, int height) {
  PlotLayout layout = LayOut(plot, width, height);
  Surface data = DataLayer(plot, layout, width, height);
  const Vec2 legend_size = LegendSize(plot, layout.unit);
  LegendPlace legend;
  if (legend_size.x > 0) {
    legend = EmptiestPlace(data, layout.frame, legend_size, layout.unit);
    const double large = legend_size.x * legend_size.y / (kLargeLegend * layout.unit * layout.unit);
    if (legend.ink * std::max(1.0, large) > kInkUnderLegend && legend_size.x < 0.5 * width) {
      layout = LayOut(plot, width, height, legend_size);
      data = DataLayer(plot, layout, width, height);
      legend.box = layout.legend;
    }
  }
  Surface picture(width, height);
  DrawGrid(picture, layout);
  picture.Paint(data);
  DrawOutline(picture, layout.frame, layout.unit);
  DrawXTicks(picture, layout);
  DrawYTicks(picture, layout.y_ticks, layout.y, layout.frame.x0, layout.unit, false);
  DrawTexts(picture, plot, layout);
  if (plot.map) DrawColourBar(picture, *plot.map, layout);
  if (legend_size.x > 0) DrawLegend(picture, plot, legend.box, layout.unit);
  return picture.ToImage();
}

}  // namespace sph
