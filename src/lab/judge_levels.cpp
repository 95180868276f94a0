#include "lab/judge_levels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.hpp"

namespace sph {
namespace {

/// Of the levels, the first one left out if errors change sign.
std::vector<Level> Sizes(const std::vector<Level>& levels, bool changes_sign) {
  std::vector<Level> sizes;
  for (std::size_t k = changes_sign ? 1 : 0; k < levels.size(); ++k) {
    const double before = changes_sign ? std::abs(levels[k - 1].value) : 0;
    sizes.push_back({levels[k].particles, std::max(before, std::abs(levels[k].value))});
  }
  return sizes;
}

/// In the spacing, which is 1/sqrt(N) of something.
std::optional<double> OrderOf(const std::vector<Level>& sizes) {
  if (sizes.size() < 2) return std::nullopt;
  const Level& coarse = sizes.front();
  const Level& fine = sizes.back();
  const double spacings = std::sqrt(static_cast<double>(fine.particles) / static_cast<double>(coarse.particles));
  return std::log(coarse.value / fine.value) / std::log(spacings);
}

void JudgeError(Judged& judged, std::size_t own) {
  const Verdict& verdict = judged.verdict;
  const auto sign = [](const Level& level) { return std::signbit(level.value); };
  judged.changes_sign = std::ranges::adjacent_find(judged.levels, std::not_equal_to<>(), sign) != judged.levels.end();
  const std::vector<Level> sizes = Sizes(judged.levels, judged.changes_sign);
  judged.order = OrderOf(sizes);
  const double finest = sizes.back().value;
  const double at_own = judged.changes_sign ? finest : std::abs(judged.levels[own].value);
  const bool finer = own + 1 < judged.levels.size();
  const bool within = at_own <= verdict.bar && (!finer || finest <= verdict.finer_bar.value_or(kBroken));
  const bool falls = std::ranges::is_sorted(sizes, std::greater_equal<>(), &Level::value);
  const bool as_promised = !judged.order || *judged.order >= verdict.promise.least;
  const bool below_floor = verdict.floor && finest <= verdict.floor->value;
  judged.holds = within && ((falls && as_promised) || below_floor);
}

double StandardDeviation(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  if (values.size() < 2) return 0;
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (n - 1));
}

bool IsBounded(const Judged& judged, std::span<const double> seeds) {
  const double chance = 2 * std::numbers::sqrt2 * StandardDeviation(seeds);
  return std::ranges::all_of(judged.levels, [&](const Level& level) {
    return std::abs(level.value) <= judged.verdict.bar &&
           std::abs(level.value) - std::abs(judged.levels.front().value) <= chance;
  });
}

}  // namespace

const char* NameOf(MetricKind kind) {
  constexpr const char* kNames[] = {"error", "bounded", "ratio", "invariant", "band", "price"};
  return kNames[static_cast<std::size_t>(kind)];
}

Judged JudgeLevels(const Verdict& verdict, std::vector<Level> levels, std::size_t own, std::span<const double> seeds) {
  SPH_CHECK(own < levels.size(), "level {} of {}", own, levels.size());
  const double floor = verdict.floor ? verdict.floor->value : 0;
  SPH_CHECK(floor <= 0.1 * verdict.bar, "{}: the floor {} is above a tenth of the bar {}", verdict.metric, floor,
            verdict.bar);
  Judged judged{verdict, std::move(levels)};
  const bool whole = std::ranges::all_of(judged.levels, [](const Level& level) { return std::isfinite(level.value); });
  if (verdict.kind == MetricKind::kError) {
    if (whole) JudgeError(judged, own);
  } else if (verdict.kind == MetricKind::kBounded) {
    judged.holds = whole && IsBounded(judged, seeds);
  } else {
    judged.holds = verdict.WithinBar();
  }
  return judged;
}

}  // namespace sph
