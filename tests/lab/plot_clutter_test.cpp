// Plots with too much in them, or nothing, at sizes from poster to thumbnail: nothing is cut off, nothing crashes.
#include <gtest/gtest.h>

#include <limits>

#include "lab/pixels.hpp"
#include "lab/plot_layout.hpp"
#include "lab/plot_surface.hpp"

namespace sph {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Size {
  int width = 0;
  int height = 0;
};

Plot Plain() {
  Plot plot;
  plot.title = "Density of a star";
  plot.x.label = "r [m]";
  plot.y.label = "ρ [kg/m³]";
  plot.series = {Curve("one", {0, 1}, {0, 2})};
  return plot;
}

/// Long texts, many decades, many series, values that cannot be shown.
Plot Full() {
  Plot plot;
  plot.title =
      "Run time against the error of the velocity after one period of the standing wave, for every solver and "
      "every resolution that was tried on this machine, with lines of first and second order";
  plot.x = {.label = "wall time on one core, without reading the scene and writing the results [s]",
            .scale = Scale::kLog};
  plot.y = {.label = "root mean square error of the velocity over its amplitude at the start", .scale = Scale::kLog};
  for (int i = 0; i < 8; ++i) {
    const std::string name = "solver number " + std::to_string(i);
    plot.series.push_back(Curve(name, {0.001, 0.1 * (i + 1), 1e6}, {0.3, kNan, 1e-9 * (i + 1)}));
  }
  return plot;
}

Plot Map() {
  Plot plot = Plain();
  plot.map = {.columns = 2, .rows = 2, .values = {1e-7, 1e-5, kNan, 1}, .extent = {0, 0, 1, 2}, .value = {}};
  plot.map->value = {.label = "largest relative error of the energy over the run", .scale = Scale::kLog};
  return plot;
}

Plot LargeNumbers() {
  Plot plot = Plain();
  plot.series = {Curve("large", {-1e12, 3e12}, {-123456, 654321}), Curve("larger", {0, 1e12}, {0, 1})};
  return plot;
}

void ExpectWhiteEdges(const Image& image, const std::string& what) {
  const Box inside = {2, 2, image.width - 2.0, image.height - 2.0};
  EXPECT_EQ(CountInk(image, WholeOf(image)), CountInk(image, inside))
      << what << " at " << image.width << " x " << image.height;
}

TEST(Draw, CutsNoTextOff) {
  for (const Size size : {Size{600, 400}, {1200, 800}, {2400, 1600}, {500, 500}, {1600, 500}}) {
    ExpectWhiteEdges(Draw(Plain(), size.width, size.height), "plain plot");
    ExpectWhiteEdges(Draw(Full(), size.width, size.height), "full plot");
    ExpectWhiteEdges(Draw(Map(), size.width, size.height), "map");
    ExpectWhiteEdges(Draw(LargeNumbers(), size.width, size.height), "plot of large numbers");
    ExpectWhiteEdges(Draw({}, size.width, size.height), "empty plot");
  }
}

TEST(Draw, WritesEveryLabelWhole) {
  // Between the left edge and the axis stand the tick labels and, turned, the axis's own; each has white around it.
  const Plot plot = LargeNumbers();
  const PlotLayout layout = LayOut(plot, 1200, 800);
  double widest = 0;
  for (const Tick& tick : layout.y_ticks) widest = std::max(widest, WidthOfText(tick.label, 22));
  EXPECT_GT(widest, 60);
  EXPECT_GT(layout.frame.x0 - widest - 13, layout.y_label_x + 0.5 * layout.y_label_size);
  EXPECT_LE(WidthOfText(plot.y.label, layout.y_label_size), layout.frame.Height());
}

TEST(Draw, LabelsOfNeighbouringTicksDoNotMeet) {
  for (const Plot& plot : {Plain(), Full(), Map(), LargeNumbers()}) {
    for (const Size size : {Size{600, 400}, {1200, 800}, {300, 300}}) {
      const PlotLayout layout = LayOut(plot, size.width, size.height);
      const double letters = 22 * layout.unit;
      double free_from = 0, free_above = size.height;
      for (const Tick& tick : layout.x_ticks) {
        if (tick.label.empty()) continue;
        const double at = layout.x.ToPixel(tick.value), half = 0.5 * WidthOfText(tick.label, letters);
        EXPECT_GT(at - half, free_from);
        free_from = at + half;
      }
      for (const Tick& tick : layout.y_ticks) {
        if (tick.label.empty()) continue;
        EXPECT_LT(layout.y.ToPixel(tick.value) + 0.5 * letters, free_above);
        free_above = layout.y.ToPixel(tick.value) - 0.5 * letters;
      }
    }
  }
}

TEST(Draw, SurvivesEveryPlotAtAnySize) {
  Plot nothing_finite = Plain();
  nothing_finite.series = {Curve("lost", {kNan, 1}, {1, kNan}), Curve("empty", {}, {})};
  Plot nothing_positive = nothing_finite;
  nothing_positive.x.scale = nothing_positive.y.scale = Scale::kLog;
  nothing_positive.series.push_back(Curve("negative", {-1, -2}, {-1, 0}));
  Plot empty_map = Plain();
  empty_map.map = HeatMap{};
  for (const Plot& plot : {Plot{}, nothing_finite, nothing_positive, empty_map, Full(), Map()}) {
    for (const Size size : {Size{1, 1}, {40, 30}, {30, 400}, {300, 200}}) {
      EXPECT_EQ(Draw(plot, size.width, size.height).width, size.width);
    }
  }
}

}  // namespace
}  // namespace sph
