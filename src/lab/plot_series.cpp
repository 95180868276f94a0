#include "lab/plot_series.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/check.hpp"
#include "lab/plot_style.hpp"

namespace sph {
namespace {

struct Piece {
  Vec2 a;
  Vec2 b;
};

/// The part of the segment in the box [Liang & Barsky 1984]: Cairo's coordinates do not reach far beyond a picture.
std::optional<Piece> Clip(Vec2 a, Vec2 b, const Box& box) {
  const Vec2 d = b - a;
  double from = 0, to = 1;
  const auto cut = [&](double rise, double room) {  // rise * s <= room
    if (rise == 0) return room >= 0;
    const double s = room / rise;
    (rise > 0 ? to : from) = rise > 0 ? std::min(to, s) : std::max(from, s);
    return from <= to;
  };
  if (!cut(-d.x, a.x - box.x0) || !cut(d.x, box.x1 - a.x) || !cut(-d.y, a.y - box.y0) || !cut(d.y, box.y1 - a.y)) {
    return std::nullopt;
  }
  // Ends far away leave rounding errors as large as the picture.
  const auto inside = [&](Vec2 p) { return Vec2{std::clamp(p.x, box.x0, box.x1), std::clamp(p.y, box.y0, box.y1)}; };
  return Piece{inside(a + from * d), inside(to == 1 ? b : a + to * d)};
}

std::optional<Vec2> ToPixel(const PlotLayout& layout, double x, double y) {
  if (!Drawable(x, layout.x.scale) || !Drawable(y, layout.y.scale)) return std::nullopt;
  return Vec2{layout.x.ToPixel(x), layout.y.ToPixel(y)};
}

void DrawLine(Surface& surface, const PlotLayout& layout, const Series& series) {
  cairo_t* context = surface.Context();
  std::optional<Vec2> last, pen;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const auto next = ToPixel(layout, series.x[i], series.y[i]);
    if (last && next) {
      if (const auto piece = Clip(*last, *next, layout.frame)) {
        if (!pen || !(*pen == piece->a)) cairo_move_to(context, piece->a.x, piece->a.y);
        cairo_line_to(context, piece->b.x, piece->b.y);
        pen = piece->b;
      }
    }
    last = next;
  }
  SetLine(surface, series, layout.unit);
  cairo_stroke(context);
}

void DrawMarkers(Surface& surface, const PlotLayout& layout, const Series& series) {
  surface.SetColour(*series.colour, series.opacity);
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const auto at = ToPixel(layout, series.x[i], series.y[i]);
    if (!at || !layout.x.Contains(series.x[i]) || !layout.y.Contains(series.y[i])) continue;
    DrawMarker(surface, series.marker, *at, series.marker_size * layout.unit);
  }
}

void FillPolygon(cairo_t* context, const std::vector<Vec2>& upper, const std::vector<Vec2>& lower) {
  if (upper.empty()) return;
  for (const Vec2 point : upper) cairo_line_to(context, point.x, point.y);
  for (auto point = lower.rbegin(); point != lower.rend(); ++point) cairo_line_to(context, point->x, point->y);
  cairo_close_path(context);
  cairo_fill(context);
}

void DrawBand(Surface& surface, const PlotLayout& layout, const Band& band) {
  SPH_CHECK(band.high.size() == band.x.size() && (band.low.empty() || band.low.size() == band.x.size()),
            "band '{}': {} x, {} low, {} high", band.name, band.x.size(), band.low.size(), band.high.size());
  cairo_t* context = surface.Context();
  cairo_save(context);
  cairo_rectangle(context, layout.frame.x0, layout.frame.y0, layout.frame.Width(), layout.frame.Height());
  cairo_clip(context);
  surface.SetColour(ColourOf(band), band.opacity);
  std::vector<Vec2> upper, lower;
  const auto near = [](Vec2 p) { return Vec2{std::clamp(p.x, -3e4, 3e4), std::clamp(p.y, -3e4, 3e4)}; };
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    const auto high = ToPixel(layout, band.x[i], band.high[i]);
    const auto low = ToPixel(layout, band.x[i], band.low.empty() ? layout.y.low : band.low[i]);
    if (high && low) {
      upper.push_back(near(*high));
      lower.push_back(near(*low));
    } else {
      FillPolygon(context, upper, lower);
      upper.clear();
      lower.clear();
    }
  }
  FillPolygon(context, upper, lower);
  cairo_restore(context);
}

/// Corners of a regular polygon with the area of a disk of radius r, the first one straight up.
void PolygonPath(cairo_t* context, Vec2 at, double r, int corners, double turn) {
  const double angle = 2 * std::numbers::pi / corners;
  const double reach = r * std::sqrt(angle / std::sin(angle));
  for (int i = 0; i < corners; ++i) {
    cairo_line_to(context, at.x + reach * std::sin(i * angle + turn), at.y - reach * std::cos(i * angle + turn));
  }
  cairo_close_path(context);
}

void CrossPath(cairo_t* context, Vec2 at, double r, double turn) {
  for (int arm = 0; arm < 2; ++arm) {
    const Vec2 d = {1.2 * r * std::cos(turn + arm * std::numbers::pi / 2),
                    1.2 * r * std::sin(turn + arm * std::numbers::pi / 2)};
    cairo_move_to(context, at.x - d.x, at.y - d.y);
    cairo_line_to(context, at.x + d.x, at.y + d.y);
  }
}

}  // namespace

void DrawMap(Surface& surface, const PlotLayout& layout, const HeatMap& map) {
  SPH_CHECK(map.values.size() == map.columns * map.rows, "{} values for {} x {} cells", map.values.size(), map.columns,
            map.rows);
  // The cells' edges as parts of the map's extent, which the axes may cut.
  const AxisMap x = {layout.x.scale, map.extent.x0, map.extent.x1}, y = {layout.y.scale, map.extent.y0, map.extent.y1};
  AxisMap value = layout.bar_values;
  value.first = 0;
  value.last = 1;
  const auto edge = [](const AxisMap& extent, const AxisMap& axis, std::size_t i, std::size_t count, double a,
                       double b) {
    const double at = axis.ToPixel(extent.At(static_cast<double>(i) / static_cast<double>(count)));
    return std::round(std::clamp(at, a, b));
  };
  const Box& f = layout.frame;
  for (std::size_t row = 0; row < map.rows; ++row) {
    for (std::size_t column = 0; column < map.columns; ++column) {
      const double v = map.values[row * map.columns + column];
      const bool drawable = Drawable(v, value.scale);
      surface.SetColour(drawable ? MapColour(std::clamp(value.ToPixel(v), 0.0, 1.0)) : kNoValueColour);
      surface.FillBox(
          {edge(x, layout.x, column, map.columns, f.x0, f.x1), edge(y, layout.y, row + 1, map.rows, f.y0, f.y1),
           edge(x, layout.x, column + 1, map.columns, f.x0, f.x1), edge(y, layout.y, row, map.rows, f.y0, f.y1)});
    }
  }
}

void DrawSeries(Surface& surface, const PlotLayout& layout, const Plot& plot) {
  for (const Band& band : plot.bands) DrawBand(surface, layout, band);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series series = Styled(plot, i);
    SPH_CHECK(series.x.size() == series.y.size(), "series '{}': {} x, {} y", series.name, series.x.size(),
              series.y.size());
    if (series.line != Line::kNone) DrawLine(surface, layout, series);
    if (series.marker != Marker::kNone) DrawMarkers(surface, layout, series);
  }
}

void SetLine(Surface& surface, const Series& series, double unit) {
  cairo_t* context = surface.Context();
  const double width = series.line_width * unit;
  const double dashes[] = {4 * width, 2.5 * width}, dots[] = {0.01 * width, 2 * width};
  surface.SetColour(*series.colour, series.opacity);
  cairo_set_line_width(context, width);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, series.line == Line::kDotted ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  if (series.line == Line::kSolid) cairo_set_dash(context, nullptr, 0, 0);
  if (series.line == Line::kDashed) cairo_set_dash(context, dashes, 2, 0);
  if (series.line == Line::kDotted) cairo_set_dash(context, dots, 2, 0);
}

void DrawMarker(Surface& surface, Marker marker, Vec2 at, double size) {
  constexpr double kPi = std::numbers::pi;
  cairo_t* context = surface.Context();
  const double r = 0.5 * size;
  cairo_new_path(context);
  switch (marker) {
    case Marker::kNone:
      return;
    case Marker::kAuto:
    case Marker::kDisk:
      cairo_arc(context, at.x, at.y, r, 0, 2 * kPi);
      break;
    case Marker::kSquare:
      PolygonPath(context, at, r, 4, kPi / 4);
      break;
    case Marker::kTriangle:
      PolygonPath(context, at, r, 3, 0);
      break;
    case Marker::kDiamond:
      PolygonPath(context, at, r, 4, 0);
      break;
    case Marker::kDownTriangle:
      PolygonPath(context, at, r, 3, kPi);
      break;
    case Marker::kCross:
    case Marker::kPlus:
      CrossPath(context, at, r, marker == Marker::kCross ? kPi / 4 : 0);
      cairo_set_dash(context, nullptr, 0, 0);
      cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
      cairo_set_line_width(context, std::max(1.0, 0.3 * size));
      cairo_stroke(context);
      return;
  }
  cairo_fill(context);
}

}  // namespace sph
