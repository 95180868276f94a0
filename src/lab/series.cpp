#include "lab/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"

namespace sph {

double ValueAt(const PointSeries& series, double x) {
  SPH_CHECK(!series.empty(), "{} points", series.size());
  const auto after = std::ranges::lower_bound(series, x, {}, &Vec2::x);
  if (after == series.begin()) return series.front().y;
  if (after == series.end()) return series.back().y;
  const Vec2 a = *(after - 1), b = *after;
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

double FirstAbove(const PointSeries& series, double level) {
  for (std::size_t i = 1; i < series.size(); ++i) {
    const Vec2 a = series[i - 1], b = series[i];
    if (a.y < level && b.y >= level) return a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y);
  }
  return std::numeric_limits<double>::infinity();
}

double Difference(const PointSeries& computed, const PointSeries& measured, double delay) {
  double squares = 0;
  for (const Vec2 point : measured) {
    const double error = ValueAt(computed, point.x - delay) - point.y;
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(measured.size()));
}

double BestDelay(const PointSeries& computed, const PointSeries& measured, double longest) {
  constexpr int kTrials = 1000;
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kTrials; ++k) {
    const double delay = longest * k / kTrials;
    const double difference = Difference(computed, measured, delay);
    if (difference < least) {
      least = difference;
      best = delay;
    }
  }
  return best;
}

}  // namespace sph
