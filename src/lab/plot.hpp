// A plot as plain data, and its picture: curves, points, bands and maps on linear or logarithmic axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "io/image.hpp"

namespace sph {

/// sRGB, each from 0 to 1.
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

enum class Scale { kLinear, kLog };

struct Axis {
  std::string label = {};  ///< quantity and unit: "r [m]"; a logarithmic axis shows decades
  Scale scale = Scale::kLinear;
  std::optional<double> low = {};   ///< where the axis begins and ends; fitted to the data where not set.
  std::optional<double> high = {};  ///< Precondition: finite, low < high; > 0 on a logarithmic axis.
};

enum class Line { kNone, kSolid, kDashed, kDotted };

/// kAuto: the next shape, so that series can be told apart without their colours.
enum class Marker { kNone, kAuto, kDisk, kSquare, kTriangle, kDiamond, kDownTriangle, kCross, kPlus };

/// Points (x[i], y[i]), in this order joined by a line, or marked, or both. What is not finite, or not positive on a
/// logarithmic axis, is left out, interrupts the line, and is counted in the note under the plot, as are markers beyond
/// the ends given for an axis.
struct Series {
  std::string name = {};  ///< in the legend; empty: not there
  std::vector<double> x = {};
  std::vector<double> y = {};  ///< as long as x
  Line line = Line::kSolid;
  Marker marker = Marker::kNone;
  std::optional<Colour> colour = {};  ///< default: the palette's next
  double opacity = 1;                 ///< of lines and markers, ]0, 1]
  double line_width = 3;              ///< [pixels of a plot of 1200 x 800, as all sizes here]
  double marker_size = 12;            ///< diameter of the disk that has the marker's area
};

/// The region low[i] <= y <= high[i] along x[i], filled behind the series.
struct Band {
  std::string name = {};  ///< in the legend; empty: not there
  std::vector<double> x = {};
  std::vector<double> low = {};  ///< as long as x; empty: down to the bottom of the plot
  std::vector<double> high = {};
  std::optional<Colour> colour = {};  ///< default: grey
  double opacity = 0.25;
};

/// A value for each of columns x rows cells, coloured; grey where it is not a number. The cells divide `extent` evenly
/// along the axes as they are shown: on a logarithmic axis, neighbouring cells have a constant ratio.
struct HeatMap {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values;  ///< columns * rows, row by row from the bottom, each from the left
  Box extent;                  ///< in the units of the plot's axes
  Axis value;                  ///< of the colour bar
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;  ///< drawn in this order, later ones over earlier ones
  std::vector<Band> bands;
  std::optional<HeatMap> map = {};
};

/// Points joined by a line and marked, each series with a shape of its own: measurements, runs.
Series Curve(std::string name, std::vector<double> x, std::vector<double> y);
/// Points alone; the more there are, the smaller and the more transparent.
Series Scatter(std::string name, std::vector<double> x, std::vector<double> y);
/// A dashed black line without markers: theory, orders of convergence.
Series Theory(std::string name, std::vector<double> x, std::vector<double> y);

/// The picture, on white. Text and lines grow with the picture: letters of 22 pixels at 1200 x 800 stay legible at half
/// that size. The legend takes the emptiest corner, or stands beside the plot if none is empty.
/// Precondition: 1 <= width, height <= 16000; series, bands and map have arrays of the lengths that they declare.
Image Draw(const Plot& plot, int width = 1200, int height = 800);

/// What of `plot` cannot be shown, counted, and why: the note under it; empty if all is shown.
std::string Omissions(const Plot& plot);

}  // namespace sph
