#include "lab/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/price_report.hpp"

namespace sph {
namespace {

/// A result in print, of a case run by a solver with as many particles as verify runs it with.
struct Published {
  const char* case_name;
  const char* who;
  double mse;  ///< of density [kg^2/m^6]
};

constexpr Published kPaper{"toy-star", "the paper's figure, solver paper's time", 0.04};

}  // namespace

std::vector<Rivalry> Compare(const PricedCase& of, const RivalRun& rival) {
  std::vector<Rivalry> rows;
  for (std::size_t metric = 0; metric < std::min(of.metrics.size(), rival.errors.size()); ++metric) {
    const double error = rival.errors[metric];
    if (!(error > 0)) continue;
    const auto ours = PricesOf(of, metric, [](const PricedRun& run) { return run.method.solver == "delta"; });
    rows.push_back(
        {of.name, rival.who, rival.particles, of.metrics[metric], error, rival.seconds, TimeToReach(ours, error)});
  }
  return rows;
}

std::vector<RivalRun> PaperRivals(const VerificationCase& of, const PricedCase& priced, const PriceOptions& options) {
  if (of.name != kPaper.case_name || options.quick) return {};
  const Method as_published{"paper", StepChoice::kScene, Precision::kDouble};
  const auto made = std::ranges::find_if(priced.runs, [&](const PricedRun& run) {
    return run.method == as_published && run.particles == priced.own_particles && run.Held();
  });
  std::vector<std::string> metrics;
  const PricedRun run =
      made != priced.runs.end() ? *made : MeasureRun(of, options, as_published, priced.own_particles, metrics);
  if (!run.Held()) return {};
  return {{of.name, "solver paper as published", run.particles, run.least, run.errors},
          {of.name, kPaper.who, run.particles, run.least, {StarErrorOf(kPaper.mse)}}};
}

namespace {
constexpr const char* kRow = "{:<14} {:<42} {:>6} {:>9} {:>9} {:>12} {:>11}  {}\n";
}

std::string RivalTableHead() {
  return "Time to be as good as others: along the frontier of solver delta\n\n" +
         fmt::format(kRow, "case", "who", "N", "error", "its [s]", "delta [s]", "ratio", "of");
}

std::string RivalTableRow(const Rivalry& row) {
  const bool never = row.ours.kind == Reach::Kind::kNever;
  const std::string ratio =
      never ? "" : fmt::format("{}{:.3g}", row.ours.kind == Reach::Kind::kAtMost ? "<= " : "", row.Ratio());
  return fmt::format(kRow, row.case_name, row.who, row.particles, fmt::format("{:.3g} %", 100 * row.error),
                     fmt::format("{:.3g}", row.seconds), row.ours.Text(), ratio, row.metric);
}

std::string RivalriesAsCsv(std::span<const Rivalry> rows) {
  std::string text = "case,who,particles,metric,error,its time [s],our time,our time [s],ratio\n";
  for (const Rivalry& row : rows) {
    const bool never = row.ours.kind == Reach::Kind::kNever;
    text += fmt::format("{},{},{},{},{},{},{}\n", CsvField(row.case_name), CsvField(row.who), row.particles,
                        CsvField(row.metric), row.error, row.seconds,
                        never ? std::string("never,,")
                              : fmt::format("{},{},{}", row.ours.kind == Reach::Kind::kAtMost ? "within" : "in",
                                            row.ours.seconds, row.Ratio()));
  }
  return text;
}

}  // namespace sph
