#include "lab/frontier.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace sph {
namespace {

constexpr std::size_t kFewestForAnOrder = 3;

bool Usable(double value) { return std::isfinite(value) && value > 0; }

}  // namespace

std::vector<std::size_t> Frontier(std::span<const Price> runs) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (Usable(runs[i].seconds) && Usable(runs[i].error)) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return runs[a].seconds != runs[b].seconds ? runs[a].seconds < runs[b].seconds : runs[a].error < runs[b].error;
  });
  std::vector<std::size_t> frontier;
  for (const std::size_t i : order) {
    if (frontier.empty() || runs[i].error < kNoticed * runs[frontier.back()].error) frontier.push_back(i);
  }
  return frontier;
}

std::string Reach::Text() const {
  if (kind == Kind::kNever) return "not reached";
  return fmt::format("{}{:.3g}", kind == Kind::kAtMost ? "<= " : "", seconds);
}

Reach TimeToReach(std::span<const Price> runs, double error) {
  SPH_CHECK(error > 0, "error = {}", error);
  const std::vector<std::size_t> frontier = Frontier(runs);
  const auto good = std::ranges::find_if(frontier, [&](std::size_t i) { return runs[i].error <= error; });
  if (good == frontier.end()) return {};
  const Price& after = runs[*good];
  if (good == frontier.begin()) return {Reach::Kind::kAtMost, after.seconds};
  const Price& before = runs[*(good - 1)];
  const double part = std::log(error / before.error) / std::log(after.error / before.error);
  return {Reach::Kind::kMeasured, before.seconds * std::pow(after.seconds / before.seconds, part)};
}

std::optional<double> FittedOrder(std::span<const double> spacings, std::span<const double> errors) {
  SPH_CHECK(spacings.size() == errors.size(), "{} spacings, {} errors", spacings.size(), errors.size());
  const auto n = static_cast<double>(errors.size());
  if (errors.size() < kFewestForAnOrder || !std::ranges::all_of(errors, Usable)) return std::nullopt;
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    x_mean += std::log(spacings[i]) / n;
    y_mean += std::log(errors[i]) / n;
  }
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = std::log(spacings[i]) - x_mean;
    xy += x * (std::log(errors[i]) - y_mean);
    xx += x * x;
  }
  return xx > 0 ? std::optional(xy / xx) : std::nullopt;
}

}  // namespace sph
