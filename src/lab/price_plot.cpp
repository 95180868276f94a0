// Run time against error as a plot.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "lab/plot_style.hpp"
#include "lab/price_report.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

constexpr double kFarTooWrong = 100;  // where the axis of errors ends at the latest

constexpr double kLeastSpan = 3;  // between least and greatest error, for an axis that is fitted to them

Colour ColourOf(const std::string& solver) {
  const auto solvers = AllSolvers();
  const auto place = std::ranges::find(solvers, solver, &Solver::name) - solvers.begin();
  constexpr std::array<std::size_t, 3> kOrder = {1, 2, 0};  // of the palette: the last solver stands out most
  return kPalette[static_cast<std::size_t>(place) < kOrder.size() ? kOrder[static_cast<std::size_t>(place)] : 3];
}

Marker MarkerOf(StepChoice step) {
  switch (step) {
    case StepChoice::kScene:
      return Marker::kDisk;
    case StepChoice::kHalf:
      return Marker::kSquare;
    case StepChoice::kAdaptive:
      return Marker::kTriangle;
  }
  return Marker::kNone;
}

/// Colour: solver; dashed: double; marker: step.
Series SeriesOf(const PricedCase& of, const Method& method) {
  Series series{.name = NameOf(method),
                .line = method.precision == Precision::kFloat ? Line::kSolid : Line::kDashed,
                .marker = MarkerOf(method.step),
                .colour = ColourOf(method.solver),
                .opacity = 0.85,
                .line_width = 1.5,
                .marker_size = 9};
  for (const Price& price : PricesOf(of, 0, [&](const PricedRun& run) { return run.method == method; })) {
    series.x.push_back(price.seconds);
    series.y.push_back(price.error);
  }
  return series;
}

Series FrontierSeries(const PricedCase& of) {
  const std::vector<Price> prices = PricesOf(of, 0, [](const PricedRun&) { return true; });
  Series series{.name = "frontier", .colour = Colour{0.75, 0.75, 0.75}, .line_width = 12};
  for (const std::size_t i : Frontier(prices)) {
    series.x.push_back(prices[i].seconds);
    series.y.push_back(prices[i].error);
  }
  return series;
}

}  // namespace

namespace {

/// The case, and the errors that the greatest is of.
std::string Title(const PricedCase& of) {
  std::string title = fmt::format("{}: {}", of.name, of.what);
  if (of.metrics.size() < 2) return title;
  return fmt::format("{}. Error: greatest of {}", title, fmt::join(of.metrics.begin() + 1, of.metrics.end(), "; "));
}

std::string ErrorLabel(const PricedCase& of) { return of.metrics.size() == 1 ? of.metrics.front() : "relative error"; }

/// In the legend, but nowhere to be seen.
Series Absent(const std::string& solver) {
  return {
      .name = fmt::format("{}: errors > {:g}", solver, kFarTooWrong), .line = Line::kNone, .colour = ColourOf(solver)};
}

}  // namespace

Plot PricePlot(const PricedCase& of, std::span<const Series> others) {
  Plot plot;
  plot.title = Title(of);
  plot.x = {of.threads == 1 ? "processor time of one thread [s]" : fmt::format("wall time, {} threads [s]", of.threads),
            Scale::kLog};
  plot.y = {ErrorLabel(of), Scale::kLog};
  plot.series.push_back(FrontierSeries(of));
  std::vector<Method> methods;
  for (const PricedRun& run : of.runs) {
    if (run.Held() && std::ranges::find(methods, run.method) == methods.end()) methods.push_back(run.method);
  }
  std::set<std::string> shown, far;
  double least = kBroken, greatest = 0;
  for (const Method& method : methods) {
    const Series series = SeriesOf(of, method);
    for (const double error : series.y) {
      least = std::min(least, error);
      greatest = std::max(greatest, error);
    }
    const auto inside = [](double error) { return error <= kFarTooWrong; };
    if (!std::ranges::all_of(series.y, inside)) plot.y.high = kFarTooWrong;
    if (std::ranges::any_of(series.y, inside)) {
      plot.series.push_back(series);
      shown.insert(method.solver);
    } else {
      far.insert(method.solver);
    }
  }
  if (greatest > 0 && greatest < kLeastSpan * least) {  // errors that are nearly equal shall look so
    plot.y.low = least / kLeastSpan;
    plot.y.high = greatest * kLeastSpan;
  }
  for (const std::string& solver : far) {
    if (!shown.contains(solver)) plot.series.push_back(Absent(solver));
  }
  plot.series.insert(plot.series.end(), others.begin(), others.end());
  return plot;
}

}  // namespace sph
