// What of a plot cannot be shown, counted, in words.
#include <fmt/format.h>

#include <algorithm>

#include "lab/plot_axes.hpp"

namespace sph {
namespace {

struct Omitted {
  long not_finite = 0;
  long not_positive = 0;
  long outside = 0;  // of the ends that the caller has given the axes; markers only: a line is cut where it leaves
};

bool Outside(double value, const Axis& axis) {
  return (axis.low && value < *axis.low) || (axis.high && value > *axis.high);
}

Omitted Count(const Plot& plot, const Series& series) {
  Omitted omitted;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const double x = series.x[i], y = series.y[i];
    if (!Drawable(x, Scale::kLinear) || !Drawable(y, Scale::kLinear)) {
      ++omitted.not_finite;
    } else if (!Drawable(x, plot.x.scale) || !Drawable(y, plot.y.scale)) {
      ++omitted.not_positive;
    } else if (series.marker != Marker::kNone && (Outside(x, plot.x) || Outside(y, plot.y))) {
      ++omitted.outside;
    }
  }
  return omitted;
}

/// "2 cells" and the like, joined by semicolons.
class Clauses {
 public:
  void Add(long count, const std::string& of_what, const char* why) {
    if (count > 0) text_ += fmt::format("{}{} {} ({})", text_.empty() ? "" : "; ", count, of_what, why);
  }
  const std::string& Text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace

std::string Omissions(const Plot& plot) {
  Clauses clauses;
  for (const Series& series : plot.series) {
    const Omitted omitted = Count(plot, series);
    const std::string of = series.name.empty() ? "points" : "of “" + series.name + "”";
    clauses.Add(omitted.not_finite, of, "not a finite number");
    clauses.Add(omitted.not_positive, of, "not positive");
    clauses.Add(omitted.outside, of, "outside the axes");
  }
  std::string note = clauses.Text().empty() ? "" : "Not shown: " + clauses.Text() + ".";
  if (!plot.map) return note;
  const auto grey = std::count_if(plot.map->values.begin(), plot.map->values.end(),
                                  [&](double v) { return !Drawable(v, plot.map->value.scale); });
  if (grey > 0) note = fmt::format("Grey: no value ({} of {} cells). ", grey, plot.map->values.size()) + note;
  return note;
}

}  // namespace sph
