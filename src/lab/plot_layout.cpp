#include "lab/plot_layout.hpp"

#include <algorithm>
#include <cmath>

#include "lab/plot_style.hpp"
#include "lab/plot_surface.hpp"

namespace sph {
namespace {

// [pixels of a plot of 1200 x 800]
constexpr double kEdge = 16;      // around everything
constexpr double kGap = 12;       // between the parts
constexpr double kBarWidth = 26;  // of the colour bar
constexpr double kTickGap = 18;   // from the frame to the labels of its ticks

std::vector<Tick> TicksOf(const AxisMap& axis, int at_most) {
  return axis.scale == Scale::kLog ? LogTicks(axis.low, axis.high, at_most) : LinearTicks(axis.low, axis.high, at_most);
}

double WidestLabel(const std::vector<Tick>& ticks, double size) {
  double widest = 0;
  for (const Tick& tick : ticks) widest = std::max(widest, WidthOfText(tick.label, size));
  return widest;
}

bool LabelsFit(const AxisMap& axis, const std::vector<Tick>& ticks, double size) {
  double free_from = -1e9;
  for (const Tick& tick : ticks) {
    if (tick.label.empty()) continue;
    const double at = axis.ToPixel(tick.value), half = 0.5 * WidthOfText(tick.label, size);
    if (at - half < free_from) return false;
    free_from = at + half + size;
  }
  return true;
}

/// As many ticks as their labels side by side leave room for.
std::vector<Tick> HorizontalTicks(const AxisMap& axis, double size) {
  for (int at_most = 9; at_most > 1; --at_most) {
    std::vector<Tick> ticks = TicksOf(axis, at_most);
    if (LabelsFit(axis, ticks, size)) return ticks;
  }
  return TicksOf(axis, 1);
}

std::vector<Tick> VerticalTicks(const AxisMap& axis, double size) {
  return TicksOf(axis, std::clamp(static_cast<int>(std::abs(axis.last - axis.first) / (2.5 * size)), 1, 9));
}

Extent ExtentOf(const Plot& plot, Scale scale, std::vector<double> Series::*component, bool vertical) {
  Extent extent(scale);
  for (const Series& series : plot.series) extent.Add(series.*component);
  for (const Band& band : plot.bands) {
    extent.Add(vertical ? band.high : band.x);
    if (vertical) extent.Add(band.low);
  }
  return extent;
}

AxisMap FitX(const Plot& plot) {
  if (!plot.map) return FitAxis(plot.x, ExtentOf(plot, plot.x.scale, &Series::x, false));
  Extent extent(plot.x.scale);
  extent.Add(plot.map->extent.x0);
  extent.Add(plot.map->extent.x1);
  return FitAxis(plot.x, extent, false);
}

AxisMap FitY(const Plot& plot) {
  if (!plot.map) return FitAxis(plot.y, ExtentOf(plot, plot.y.scale, &Series::y, true));
  Extent extent(plot.y.scale);
  extent.Add(plot.map->extent.y0);
  extent.Add(plot.map->extent.y1);
  return FitAxis(plot.y, extent, false);
}

TextBlock Wrapped(const std::string& text, double size, double width) {
  TextBlock block{Wrap(text, size, width), size, 0};
  for (const std::string& line : block.lines) block.size = std::min(block.size, FittingSize(line, size, width));
  return block;
}

double HeightOf(const TextBlock& block, double gap) {
  return block.lines.empty() ? 0 : static_cast<double>(block.lines.size()) * LineHeight(block.size) + gap;
}

/// From top and bottom towards the frame, which gets what is left.
void LayOutRows(const Plot& plot, PlotLayout& layout, int width, int height) {
  const double u = layout.unit, edge = kEdge * u, inner = width - 2 * edge;
  layout.title = Wrapped(plot.title, kTitleSize * u, inner);
  layout.title.top = edge;
  layout.frame.y0 = edge + HeightOf(layout.title, kGap * u);
  if (layout.title.lines.empty()) layout.frame.y0 += 0.5 * LineHeight(kTickSize * u);

  layout.note = Wrapped(Omissions(plot), kNoteSize * u, inner);
  layout.note.top = height - edge - HeightOf(layout.note, 0);
  layout.x_label = Wrapped(plot.x.label, kLabelSize * u, 0.8 * inner);
  layout.x_label.top = layout.note.top - HeightOf(layout.x_label, layout.note.lines.empty() ? 0 : 0.5 * kGap * u);
  layout.frame.y1 = layout.x_label.top - LineHeight(kTickSize * u) - 0.75 * kTickGap * u;
  layout.frame.y1 = std::max(layout.frame.y1, layout.frame.y0 + 1);
  layout.y.first = layout.bar_values.first = layout.frame.y1;
  layout.y.last = layout.bar_values.last = layout.frame.y0;
}

void LayOutLeft(const Plot& plot, PlotLayout& layout) {
  const double u = layout.unit, edge = kEdge * u;
  layout.y_ticks = VerticalTicks(layout.y, kTickSize * u);
  layout.y_label_size = FittingSize(plot.y.label, kLabelSize * u, layout.frame.Height());
  layout.y_label_x = edge + 0.5 * kLabelSize * u;
  const double label = plot.y.label.empty() ? 0 : LineHeight(kLabelSize * u) + 0.5 * kGap * u;
  layout.frame.x0 = edge + label + WidestLabel(layout.y_ticks, kTickSize * u) + kTickGap * u;
}

/// Colour bar and legend; returns how much of the width they take.
double LayOutRight(const Plot& plot, PlotLayout& layout, Vec2 legend, int width) {
  const double u = layout.unit;
  double right = width - kEdge * u;
  if (legend.x > 0) {
    layout.legend = {right - legend.x, layout.frame.y0, right, layout.frame.y0 + legend.y};
    right -= legend.x + kGap * u;
  }
  if (!plot.map) return width - right;
  layout.bar_ticks = VerticalTicks(layout.bar_values, kTickSize * u);
  layout.bar_label_size = FittingSize(plot.map->value.label, kLabelSize * u, layout.frame.Height());
  if (!plot.map->value.label.empty()) {
    layout.bar_label_x = right - 0.5 * LineHeight(kLabelSize * u);
    right -= LineHeight(kLabelSize * u) + kGap * u;
  }
  right -= WidestLabel(layout.bar_ticks, kTickSize * u) + kTickGap * u;
  layout.bar = {right - kBarWidth * u, layout.frame.y0, right, layout.frame.y1};
  return width - layout.bar.x0 + 2 * kGap * u;
}

/// The frame's right edge, so far left that the last label is still in the picture.
void LayOutColumns(PlotLayout& layout, double right_used, int width) {
  const double size = kTickSize * layout.unit;
  layout.x.first = layout.frame.x0;
  double right = width - std::max(right_used, kEdge * layout.unit);
  for (int round = 0; round < 2; ++round) {
    layout.frame.x1 = layout.x.last = std::max(right, layout.frame.x0 + 1);
    layout.x_ticks = HorizontalTicks(layout.x, size);
    double beyond = 0;
    for (const Tick& tick : layout.x_ticks) {
      const double end = layout.x.ToPixel(tick.value) + 0.5 * WidthOfText(tick.label, size);
      beyond = std::max(beyond, end + kEdge * layout.unit - width);
    }
    right -= beyond;
  }
}

void Snap(Box& box) { box = {std::round(box.x0), std::round(box.y0), std::round(box.x1), std::round(box.y1)}; }

}  // namespace

PlotLayout LayOut(const Plot& plot, int width, int height, Vec2 legend) {
  PlotLayout layout;
  layout.unit = std::max(0.4, std::min(width / 1200.0, height / 800.0));
  layout.x = FitX(plot);
  layout.y = FitY(plot);
  if (plot.map) {
    Extent values(plot.map->value.scale);
    values.Add(plot.map->values);
    layout.bar_values = FitAxis(plot.map->value, values, false);
  }
  LayOutRows(plot, layout, width, height);
  LayOutLeft(plot, layout);
  LayOutColumns(layout, LayOutRight(plot, layout, legend, width), width);

  // Whole pixels, so that frame, grid and map have sharp edges.
  Snap(layout.frame);
  Snap(layout.bar);
  layout.x.first = layout.frame.x0;
  layout.x.last = layout.frame.x1;
  layout.y.first = layout.bar_values.first = layout.frame.y1;
  layout.y.last = layout.bar_values.last = layout.frame.y0;
  return layout;
}

}  // namespace sph
