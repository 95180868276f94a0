#include "commands/verify.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/nearest_name.hpp"
#include "commands/interrupt.hpp"
#include "lab/verify_runs.hpp"

namespace sph {
namespace {

std::vector<const VerificationCase*> Chosen(const VerifyOptions& options) {
  std::vector<const VerificationCase*> chosen;
  std::vector<std::string> names;
  for (const VerificationCase& of : AllVerificationCases()) {
    names.push_back(of.name);
    const bool named = std::ranges::find(options.cases, of.name) != options.cases.end();
    if (named || (options.cases.empty() && (options.all || !of.slow))) chosen.push_back(&of);
  }
  for (const std::string& name : options.cases) {
    if (std::ranges::find(names, name) == names.end()) {
      throw UsageError("verify: unknown case '{}'.{} There are: {}", name, DidYouMean(name, names),
                       fmt::join(names, ", "));
    }
  }
  return chosen;
}

/// Numbers of particles, or values, in the three columns of a ladder.
template <typename Text>
std::string Columns(const std::vector<Level>& levels, Text text) {
  constexpr std::size_t kColumns = 3;
  std::string line;
  for (std::size_t k = 0; k < kColumns; ++k) line += fmt::format(" {:>9}", k < levels.size() ? text(levels[k]) : "");
  return line;
}

/// The ladder that most of the metrics have: what stands above the columns.
const std::vector<Level>& LongestLadder(const std::vector<Judged>& metrics) {
  return std::ranges::max_element(metrics, {}, [](const Judged& of) { return of.levels.size(); })->levels;
}

/// The levels of a metric below those numbers of particles: one that was run once stands below its own.
std::vector<Level> Aligned(const Judged& metric, const std::vector<Level>& ladder) {
  if (metric.levels.size() == ladder.size()) return metric.levels;
  std::vector<Level> aligned;
  for (const Level& level : ladder) {
    const bool own = level.particles == metric.levels.front().particles;
    aligned.push_back({level.particles, own ? metric.levels.front().value : std::nan("")});
  }
  return aligned;
}

std::string OrderOf(const Judged& metric) {
  if (metric.changes_sign) return "sign";
  return metric.order ? fmt::format("{:.2f}", *metric.order) : "";
}

/// What the row is judged by, in words.
std::string RuleOf(const Judged& metric) {
  const Verdict& verdict = metric.verdict;
  std::string rule = verdict.reference;
  if (verdict.kind != MetricKind::kError) return rule;
  rule += fmt::format("; promised order {:.3g}: {}", verdict.promise.order, verdict.promise.why);
  if (verdict.promise.least > 0.5 * verdict.promise.order) {
    rule += fmt::format("; {:.3g} at least", verdict.promise.least);
  }
  if (verdict.finer_bar) rule += fmt::format("; bar {:.2g} with most particles", *verdict.finer_bar);
  if (verdict.floor) rule += fmt::format("; floor {:.2g}: {}", verdict.floor->value, verdict.floor->why);
  if (metric.changes_sign) rule += "; the sign changes: judged by the greater of two neighbours";
  return rule;
}

/// Words in lines that fit into a terminal, each after the indent of the kinds' column.
std::string Wrapped(const std::string& words) {
  constexpr std::size_t kWidth = 108, kIndent = 12;
  std::istringstream stream(words);
  std::string text, line;
  for (std::string word; stream >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kWidth) {
      text += fmt::format("{:{}}{}\n", "", kIndent, line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + fmt::format("{:{}}{}\n", "", kIndent, line);
}

void PrintCase(const VerificationCase& of, const CaseResult& result) {
  constexpr const char* kRow = "  {:<9} {:<58}{} {:>6} {:>5} {}\n";
  const std::vector<Level>& ladder = LongestLadder(result.metrics);
  const auto number = [](const Level& level) { return fmt::format("{}", level.particles); };
  const auto value = [](const Level& level) {
    return std::isnan(level.value) ? "" : fmt::format("{:.3g}", level.value);
  };
  fmt::print("\n{}: {} ({}, {:.1f} s)\n", of.name, of.what, result.solver, result.seconds);
  fmt::print(kRow, "kind", "metric with so many particles:", Columns(ladder, number), "bar", "order", "");
  for (const Judged& metric : result.metrics) {
    fmt::print(kRow, NameOf(metric.verdict.kind), metric.verdict.metric, Columns(Aligned(metric, ladder), value),
               fmt::format("{:.2g}", metric.verdict.bar), OrderOf(metric), metric.holds ? "holds" : "open");
    fmt::print("{}", Wrapped(RuleOf(metric)));
  }
  std::fflush(stdout);
}

nlohmann::ordered_json AsJson(const VerificationCase& of, const CaseResult& result, const Judged& metric) {
  nlohmann::ordered_json ladder = nlohmann::ordered_json::array();
  for (const Level& level : metric.levels) ladder.push_back({level.particles, level.value});
  return {{"case", of.name},
          {"solver", result.solver},
          {"particles", result.particles},
          {"metric", metric.verdict.metric},
          {"kind", NameOf(metric.verdict.kind)},
          {"value", metric.verdict.value},
          {"bar", metric.verdict.bar},
          {"holds", metric.holds},
          {"order", metric.order && !metric.changes_sign ? nlohmann::ordered_json(*metric.order) : nullptr},
          {"ladder", ladder},
          {"reference", RuleOf(metric)},
          {"wall_seconds", result.seconds}};
}

}  // namespace

ExitCode Verify(const VerifyOptions& options) {
  const auto cases = Chosen(options);
  EndWhenInterrupted();
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  bool all_hold = true;
  for (const VerificationCase* of : cases) {
    const CaseResult result = RunCase(*of, {options.all, options.threads});
    for (const Judged& metric : result.metrics) {
      all_hold = all_hold && metric.holds;
      if (options.json) report.push_back(AsJson(*of, result, metric));
    }
    if (!options.json) PrintCase(*of, result);
  }
  if (options.json) fmt::print("{}\n", report.dump(2));
  return all_hold ? ExitCode::kDone : ExitCode::kTrouble;
}

}  // namespace sph
