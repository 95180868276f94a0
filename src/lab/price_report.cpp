#include "lab/price_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sph/solvers.hpp"

namespace sph {
namespace {

std::string_view NameOfPrecision(const Method& method) {
  return method.precision == Precision::kFloat ? "float" : "double";
}

double SpacingOf(const PricedRun& run) { return 1 / std::sqrt(static_cast<double>(run.particles)); }

/// Of the three finest runs with the case's own fixed step in double.
std::optional<double> OrderOf(const PricedCase& of, std::size_t metric, const std::string& solver) {
  constexpr std::size_t kFinest = 3;
  std::vector<double> spacings, errors;
  for (const PricedRun& run : of.runs) {
    const Method& m = run.method;
    if (m.solver != solver || m.step != StepChoice::kScene || m.precision != Precision::kDouble || !run.Held())
      continue;
    spacings.push_back(SpacingOf(run));
    errors.push_back(run.errors[metric]);
  }
  if (errors.size() < kFinest) return std::nullopt;
  const auto past = static_cast<std::ptrdiff_t>(errors.size() - kFinest);
  return FittedOrder(std::span(spacings).subspan(static_cast<std::size_t>(past)),
                     std::span(errors).subspan(static_cast<std::size_t>(past)));
}

/// Why a solver has no run that held: the note of its last one.
std::string WhyNothing(const PricedCase& of, const std::string& solver) {
  std::string note;
  for (const PricedRun& run : of.runs) {
    if (run.method.solver == solver) note = run.note;
  }
  return note.empty() ? "no run" : note;
}

std::string Percent(double error) { return std::isfinite(error) ? fmt::format("{:.3g} %", 100 * error) : "-"; }

}  // namespace

std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string PricesAsCsv(const PricedCase& of) {
  std::string text = "case,solver,precision,step,particles,steps,repetitions,least [s],greatest [s]";
  for (const std::string& metric : of.metrics) text += fmt::format(",{}", CsvField(metric));
  text += ",note\n";
  for (const PricedRun& run : of.runs) {
    text += fmt::format("{},{},{},{},{},", CsvField(of.name), run.method.solver, NameOfPrecision(run.method),
                        NameOf(run.method.step), run.particles);
    text +=
        run.repetitions > 0 ? fmt::format("{},{},{},{}", run.steps, run.repetitions, run.least, run.greatest) : ",0,,";
    for (std::size_t k = 0; k < of.metrics.size(); ++k) {
      text += run.Held() ? fmt::format(",{}", run.errors[k]) : ",";
    }
    text += fmt::format(",{}\n", CsvField(run.note));
  }
  return text;
}

std::vector<PriceSummary> Summarise(const PricedCase& of) {
  std::vector<PriceSummary> rows;
  for (std::size_t metric = 0; metric < of.metrics.size(); ++metric) {
    for (const Solver& solver : AllSolvers()) {
      PriceSummary row{.case_name = of.name, .metric = of.metrics[metric], .solver = solver.name};
      const auto of_solver = [&](const PricedRun& run) { return run.method.solver == solver.name; };
      const std::vector<Price> prices = PricesOf(of, metric, of_solver);
      if (prices.empty() && metric > 0) continue;
      for (const double wanted : kWantedErrors) row.reached.push_back(TimeToReach(prices, wanted));
      for (const PricedRun& run : of.runs) {
        if (!of_solver(run) || !run.Held() || !(run.errors[metric] < row.least_error)) continue;
        row.least_error = run.errors[metric];
        row.method = fmt::format("{} {}", NameOfPrecision(run.method), NameOf(run.method.step));
        row.particles = run.particles;
        row.seconds = run.least;
      }
      row.order = OrderOf(of, metric, solver.name);
      if (prices.empty()) row.note = WhyNothing(of, solver.name);
      rows.push_back(row);
    }
  }
  return rows;
}

namespace {
constexpr const char* kSummaryRow = "{:<17} {:<8} {:>12} {:>12} {:>9} {:>7} {:>9}  {:<15} {:>5}  {}\n";
}

std::string SummaryTableHead() {
  return fmt::format(kSummaryRow, "case", "solver", "1 % [s]", "0.1 % [s]", "least", "N", "[s]", "with", "order",
                     "of this error");
}

std::string SummaryTableRow(const PriceSummary& row) {
  if (!row.note.empty()) return fmt::format("{:<17} {:<8} {}  {}\n", row.case_name, row.solver, "none:", row.note);
  return fmt::format(kSummaryRow, row.case_name, row.solver, row.reached[0].Text(), row.reached[1].Text(),
                     Percent(row.least_error), row.particles, fmt::format("{:.3g}", row.seconds), row.method,
                     row.order ? fmt::format("{:.1f}", *row.order) : "", row.metric);
}

std::string SummariesAsCsv(std::span<const PriceSummary> rows) {
  std::string text =
      "case,metric,solver,1 % reached,1 % [s],0.1 % reached,0.1 % [s],least error,its precision and step,its particles,"
      "its time [s],order,note\n";
  for (const PriceSummary& row : rows) {
    text += fmt::format("{},{},{}", CsvField(row.case_name), CsvField(row.metric), row.solver);
    for (const Reach& reach : row.reached) {
      const bool never = reach.kind == Reach::Kind::kNever;
      text += never ? ",never,"
                    : fmt::format(",{},{}", reach.kind == Reach::Kind::kAtMost ? "within" : "in", reach.seconds);
    }
    text += row.note.empty() ? fmt::format(",{},{},{},{}", row.least_error, row.method, row.particles, row.seconds)
                             : ",,,,";
    text += fmt::format(",{},{}\n", row.order ? fmt::format("{:.3f}", *row.order) : "", CsvField(row.note));
  }
  return text;
}

namespace {

/// The same run in double, if it held.
const PricedRun* TwinOf(const PricedRun& single, const PricedCase& of) {
  Method method = single.method;
  method.precision = Precision::kDouble;
  const auto twin = std::ranges::find_if(of.runs, [&](const PricedRun& run) {
    return run.method == method && run.particles == single.particles && run.Held();
  });
  return twin == of.runs.end() ? nullptr : &*twin;
}

}  // namespace

namespace {

FloatEnd FloatEndOf(const PricedCase& of, std::size_t metric, const std::string& solver) {
  constexpr double kAsGood = 1.1;
  constexpr double kWrongAnyway = 0.1;
  FloatEnd row{.case_name = of.name, .metric = of.metrics[metric], .solver = solver};
  for (const PricedRun& single : of.runs) {
    if (single.method.solver != solver || single.method.precision != Precision::kFloat || !single.Held()) continue;
    const PricedRun* twin = TwinOf(single, of);
    if (twin == nullptr || twin->errors[metric] > kWrongAnyway || twin->errors[metric] <= 0) continue;
    const double in_float = single.errors[metric], in_double = twin->errors[metric];
    const double ratio = in_float / in_double;
    if (ratio <= kAsGood && in_double < row.good_error) {
      row.good_error = in_double;
      row.good_particles = single.particles;
    }
    if (ratio > row.worst_ratio) {
      row.worst_ratio = ratio;
      row.worst_particles = single.particles;
      row.worst_float = in_float;
      row.worst_double = in_double;
    }
  }
  return row;
}

}  // namespace

std::vector<FloatEnd> FloatEnds(const PricedCase& of) {
  std::vector<FloatEnd> rows;
  for (std::size_t metric = 0; metric < of.metrics.size(); ++metric) {
    for (const Solver& solver : AllSolvers()) {
      const FloatEnd row = FloatEndOf(of, metric, solver.name);
      if (row.worst_ratio > 0) rows.push_back(row);
    }
  }
  return rows;
}

namespace {
constexpr const char* kFloatRow = "{:<17} {:<8} {:>12} {:>6}   {:>8} {:>6} {:>11} {:>11}  {}\n";
}

std::string FloatTableHead() {
  return "Where float ends: the least error that passes in float reach as those in double do (to a tenth), and where\n"
         "float is worst: pairs of runs that are alike otherwise, unless double is wrong by more than 10 % itself\n\n" +
         fmt::format(kFloatRow, "case", "solver", "as good at", "N", "worst", "N", "in float", "in double",
                     "of this error");
}

std::string FloatTableRow(const FloatEnd& r) {
  return fmt::format(kFloatRow, r.case_name, r.solver, Percent(r.good_error),
                     r.good_particles > 0 ? fmt::format("{}", r.good_particles) : "-",
                     fmt::format("{:.3g}x", r.worst_ratio), r.worst_particles, Percent(r.worst_float),
                     Percent(r.worst_double), r.metric);
}

std::string FloatEndsAsCsv(std::span<const FloatEnd> rows) {
  std::string text =
      "case,metric,solver,least error as good,its particles,greatest ratio,its particles,its error in float,its error "
      "in "
      "double\n";
  for (const FloatEnd& r : rows) {
    const std::string good = r.good_particles > 0 ? fmt::format("{},{}", r.good_error, r.good_particles) : ",";
    text += fmt::format("{},{},{},{},{},{},{},{}\n", CsvField(r.case_name), CsvField(r.metric), r.solver, good,
                        r.worst_ratio, r.worst_particles, r.worst_float, r.worst_double);
  }
  return text;
}

}  // namespace sph
