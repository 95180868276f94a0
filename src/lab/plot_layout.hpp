// Where the parts of a plot go: title, frame, labels, colour bar, legend, note.
#pragma once

#include <string>
#include <vector>

#include "lab/plot_axes.hpp"

namespace sph {

/// One or more lines of text from `top` [pixels] down.
struct TextBlock {
  std::vector<std::string> lines;
  double size = 0;  // [pixels]
  double top = 0;
};

struct PlotLayout {
  double unit = 1;  ///< pixels of this plot for one of a plot of 1200 x 800
  Box frame;        ///< where the data are shown; y0 is its upper edge [pixels]
  AxisMap x;
  AxisMap y;
  std::vector<Tick> x_ticks;
  std::vector<Tick> y_ticks;
  TextBlock title;
  TextBlock x_label;
  TextBlock note;
  double y_label_x = 0;  ///< the middle of its capital letters
  double y_label_size = 0;

  Box bar;  ///< the colour bar of the map; empty without one
  AxisMap bar_values;
  std::vector<Tick> bar_ticks;
  double bar_label_x = 0;
  double bar_label_size = 0;

  Box legend;  ///< where it stands if it stands beside the frame; empty otherwise
};

/// The layout with `legend` pixels beside the frame for a legend of that size; {0, 0}: none there.
PlotLayout LayOut(const Plot& plot, int width, int height, Vec2 legend = {});

}  // namespace sph
