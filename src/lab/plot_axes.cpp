#include "lab/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"

namespace sph {
namespace {

constexpr double kLargest = 1e300;   // of what is drawn: differences of two such values are finite
constexpr double kRoundOff = 1e-9;   // of a step, by which a tick may miss the axis's end
constexpr double kNarrowest = 1e-9;  // of its values, the shortest axis: labels need not more than ten digits
constexpr double kMargin = 0.04;     // of the axis, beyond the data

double Power10(int exponent) { return std::pow(10.0, exponent); }

int Exponent(double value) { return static_cast<int>(std::floor(std::log10(value) + kRoundOff)); }

/// How all labels of an axis are written: value / 10^exponent with `decimals` digits after the point.
struct NumberFormat {
  int exponent = 0;
  int decimals = 0;
};

NumberFormat FormatFor(double low, double high, double step) {
  const int largest = Exponent(std::max(std::abs(low), std::abs(high)));
  const int exponent = largest >= -3 && largest <= 5 ? 0 : largest;
  return {exponent, std::max(0, exponent - Exponent(step))};
}

std::string Label(double value, NumberFormat format) {
  if (value == 0) return "0";
  std::string label = fmt::format("{:.{}f}", std::abs(value) / Power10(format.exponent), format.decimals);
  if (format.exponent != 0) label += "×" + PowerOfTen(format.exponent);
  return (value < 0 ? "−" : "") + label;
}

/// The multiples of `step` in [low, high].
struct Multiples {
  double first = 0;
  double last = 0;
  Multiples(double low, double high, double step)
      : first(std::ceil(low / step - kRoundOff)), last(std::floor(high / step + kRoundOff)) {}
  double Count() const { return last - first + 1; }
};

double RoundStep(double low, double high, int at_most) {
  constexpr std::array<double, 3> kMantissas = {1, 2, 5};
  for (int exponent = Exponent((high - low) / (at_most + 1));; ++exponent) {
    for (const double mantissa : kMantissas) {
      const double step = mantissa * Power10(exponent);
      if (Multiples(low, high, step).Count() <= at_most) return step;
    }
  }
}

struct Decades {
  int first = 0;
  int last = 0;
  Decades(double low, double high)
      : first(static_cast<int>(std::ceil(std::log10(low) - kRoundOff))),
        last(static_cast<int>(std::floor(std::log10(high) + kRoundOff))) {}
  int Count() const { return last - first + 1; }
};

std::vector<Tick> DecadeTicks(double low, double high, Decades decades, int at_most) {
  const int every = (decades.Count() + at_most - 1) / at_most;
  const bool plain = std::max(std::abs(decades.first), std::abs(decades.last)) <= 2;
  std::vector<Tick> ticks;
  for (int n = decades.first - 1; n <= decades.last; ++n) {
    if (n >= decades.first) {
      const bool labelled = (n - decades.first) % every == 0;
      const std::string label = plain ? Label(Power10(n), {0, std::max(0, -n)}) : PowerOfTen(n);
      ticks.push_back({std::clamp(Power10(n), low, high), labelled ? label : ""});
    }
    if (every > 1) continue;
    for (int digit = 2; digit <= 9; ++digit) {
      const double value = digit * Power10(n);
      if (value >= low && value <= high) ticks.push_back({value, ""});
    }
  }
  return ticks;
}

/// 1 ... 9 times the powers of ten in [low, high], labelled where the digit is one of `labelled`.
std::vector<Tick> DigitTicks(double low, double high, std::string_view labelled) {
  std::vector<Tick> ticks;
  const Decades decades(low, high);
  for (int n = decades.first - 1; n <= decades.last; ++n) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * Power10(n);
      if (value < low || value > high) continue;
      const bool plain = n >= -3 && n <= 4;
      const NumberFormat format = plain ? NumberFormat{0, std::max(0, -n)} : NumberFormat{n, 0};
      const bool has_label = labelled.find(static_cast<char>('0' + digit)) != std::string_view::npos;
      ticks.push_back({value, has_label ? Label(value, format) : ""});
    }
  }
  return ticks;
}

double ToAxis(double value, Scale scale) { return scale == Scale::kLog ? std::log10(value) : value; }
double FromAxis(double position, Scale scale) { return scale == Scale::kLog ? std::pow(10.0, position) : position; }

/// Both in the axis's own measure: decades on a logarithmic axis.
struct DataEnds {
  double low = 0;
  double high = 1;
};

DataEnds Widened(DataEnds ends, Scale scale) {
  const double size = std::max(std::abs(ends.low), std::abs(ends.high));
  const double least = scale == Scale::kLog ? kNarrowest : std::max(kNarrowest * size, 1 / kLargest);
  if (ends.high - ends.low > least) return ends;
  const double room = scale == Scale::kLog ? 0.5 : (size > 1 / kLargest ? 0.1 * size : 1);
  return {ends.low - room, ends.high + room};
}

DataEnds WithMargin(DataEnds ends, Scale scale) {
  const double margin = kMargin * (ends.high - ends.low);
  DataEnds wider = {ends.low - margin, ends.high + margin};
  if (scale == Scale::kLinear && ends.low >= 0) wider.low = std::max(wider.low, 0.0);
  if (scale == Scale::kLinear && ends.high <= 0) wider.high = std::min(wider.high, 0.0);
  const double furthest = scale == Scale::kLog ? std::log10(kLargest) : 2 * kLargest;
  return {std::max(wider.low, -furthest), std::min(wider.high, furthest)};
}

}  // namespace

std::string PowerOfTen(int exponent) {
  constexpr std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : fmt::format("{}", std::abs(exponent))) text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::vector<Tick> LinearTicks(double low, double high, int at_most) {
  SPH_CHECK(low < high && std::isfinite(high - low) && at_most >= 1, "low = {}, high = {}, at_most = {}", low, high,
            at_most);
  const double step = RoundStep(low, high, at_most);
  const NumberFormat format = FormatFor(low, high, step);
  const Multiples multiples(low, high, step);
  std::vector<Tick> ticks;
  for (int i = 0; i < static_cast<int>(multiples.Count()); ++i) {
    const double value = (multiples.first + i) * step;
    ticks.push_back({std::clamp(value, low, high), Label(value, format)});
  }
  return ticks;
}

std::vector<Tick> LogTicks(double low, double high, int at_most) {
  SPH_CHECK(0 < low && low < high && at_most >= 1, "low = {}, high = {}, at_most = {}", low, high, at_most);
  const Decades decades(low, high);
  if (decades.Count() >= 3) return DecadeTicks(low, high, decades, at_most);
  for (const std::string_view digits : {"125", "13"}) {
    std::vector<Tick> ticks = DigitTicks(low, high, digits);
    const auto labels = std::count_if(ticks.begin(), ticks.end(), [](const Tick& t) { return !t.label.empty(); });
    if (labels >= 2 && labels <= at_most) return ticks;
  }
  return decades.Count() == 2 ? DecadeTicks(low, high, decades, at_most) : LinearTicks(low, high, at_most);
}

bool Drawable(double value, Scale scale) {
  return std::abs(value) < kLargest && (scale == Scale::kLinear || value > 1 / kLargest);
}

void Extent::Add(double value) {
  if (!Drawable(value, scale_)) return;
  const bool empty = Empty();
  low_ = empty ? value : std::min(low_, value);
  high_ = empty ? value : std::max(high_, value);
}

void Extent::Add(std::span<const double> values) {
  for (const double value : values) Add(value);
}

double AxisMap::ToPixel(double value) const {
  const double a = ToAxis(low, scale);
  const double b = ToAxis(high, scale);
  return first + (last - first) * ((ToAxis(value, scale) - a) / (b - a));
}

double AxisMap::At(double part) const {
  const double a = ToAxis(low, scale);
  return FromAxis(a + part * (ToAxis(high, scale) - a), scale);
}

AxisMap FitAxis(const Axis& axis, const Extent& data, bool margin) {
  for (const auto& end : {axis.low, axis.high}) {
    SPH_CHECK(!end || Drawable(*end, axis.scale), "axis '{}' ends at {}", axis.label, *end);
  }
  DataEnds ends = {0, 1};
  if (!data.Empty()) {
    ends = Widened({ToAxis(data.Low(), axis.scale), ToAxis(data.High(), axis.scale)}, axis.scale);
    if (margin) ends = WithMargin(ends, axis.scale);
  }
  const double length = ends.high - ends.low;
  if (axis.low && ends.high <= ToAxis(*axis.low, axis.scale)) ends.high = ToAxis(*axis.low, axis.scale) + length;
  if (axis.high && ends.low >= ToAxis(*axis.high, axis.scale)) ends.low = ToAxis(*axis.high, axis.scale) - length;
  const double low = axis.low ? *axis.low : FromAxis(ends.low, axis.scale);
  const double high = axis.high ? *axis.high : FromAxis(ends.high, axis.scale);
  SPH_CHECK(low < high, "axis '{}' from {} to {}", axis.label, low, high);
  return {axis.scale, low, high};
}

}  // namespace sph
