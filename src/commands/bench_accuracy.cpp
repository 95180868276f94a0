// `sphlab bench CASE`: run time against error.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands/bench.hpp"
#include "commands/bench_protocol.hpp"
#include "commands/interrupt.hpp"
#include "io/png.hpp"
#include "io/whole_file.hpp"
#include "lab/price_report.hpp"
#include "lab/rivals.hpp"

namespace sph {
namespace {

constexpr double kQuick = 0.1;  // [s], of a run of a quick bench

/// What the cases have in common, as it grows.
struct Results {
  std::vector<PriceSummary> summaries;
  std::vector<FloatEnd> float_ends;
  std::vector<Rivalry> rivalries;
};

double Longest(const BenchOptions& options) {
  return options.quick ? std::min(options.longest, kQuick) : options.longest;
}

PriceOptions AsPriceOptions(const BenchOptions& options) { return {Longest(options), options.quick, options.threads}; }

std::string Head(const BenchOptions& options) {
  const std::string seconds = options.threads == 1 ? std::string("processor time of the program, which has one thread")
                                                   : fmt::format("wall time, {} threads", options.threads);
  return DescribeMachine() +
         fmt::format(
             "Seconds to reach an error: {}.\n"
             "They go from a run's first step to its last measurement: the start is left out, what is looked at on "
             "the\n"
             "way is included (up to some percent). Short runs are repeated, and the least counts. Between two runs "
             "the\n"
             "logarithms are joined by a line; <= where the quickest run is good enough already. N goes from 1/64 to\n"
             "{} times that of verify; runs that would take more than {:g} s are left out. Order: error ~ "
             "spacing^order\n"
             "of the three finest runs in double with the scene's fixed step, which goes with the spacing.\n\n",
             seconds, options.quick ? "1/4" : "4", Longest(options));
}

void Tell(const std::string& what) {
  if (isatty(STDERR_FILENO) == 1) fmt::print(stderr, "{}\n", what);
}

std::vector<RivalRun> Rivals(const VerificationCase& of, const PricedCase& priced, const BenchOptions& options) {
  std::vector<RivalRun> rivals = PaperRivals(of, priced, AsPriceOptions(options));
  if (!options.peers) return rivals;
  for (const int resolution : PySphResolutions(of.name)) {
    if (Interrupted()) break;
    Tell(fmt::format("{}: PySPH", of.name));
    try {
      rivals.push_back(RunPySph(of, resolution, options.out));
    } catch (const TroubleError&) {
      if (!Interrupted()) throw;  // the interruption ended it, too
    }
    if (options.quick) break;
  }
  return rivals;
}

/// Their errors in the case's first metric, one series for runs of the same name.
std::vector<Series> AsSeries(const std::vector<RivalRun>& rivals) {
  std::vector<Series> all;
  for (const RivalRun& rival : rivals) {
    if (all.empty() || all.back().name != rival.who) {
      all.push_back(Scatter(rival.who, {}, {}));
      all.back().colour = Colour{};
      all.back().marker_size = 14;
    }
    all.back().x.push_back(rival.seconds);
    all.back().y.push_back(rival.errors.front());
  }
  return all;
}

/// Runs a case and writes its files; false if it was interrupted.
bool BenchCase(const VerificationCase& of, const BenchOptions& options, Protocol& table, Results& results) {
  Tell(of.name);
  const PricedCase priced = MeasurePrices(of, AsPriceOptions(options), &Interrupted);
  const std::vector<RivalRun> rivals = Rivals(of, priced, options);
  if (Interrupted()) return false;
  const std::filesystem::path out = options.out;
  WriteWholeFile(out / (of.name + ".csv"), PricesAsCsv(priced));
  WritePng(out / (of.name + ".png"), Draw(PricePlot(priced, AsSeries(rivals))));
  for (const PriceSummary& row : Summarise(priced)) {
    table.Add(SummaryTableRow(row));
    results.summaries.push_back(row);
  }
  for (const FloatEnd& row : FloatEnds(priced)) results.float_ends.push_back(row);
  for (const RivalRun& rival : rivals) {
    for (const Rivalry& row : Compare(priced, rival)) results.rivalries.push_back(row);
  }
  return true;
}

/// What stands below the table of errors.
std::string Comparisons(const Results& results) {
  std::string text = fmt::format("\n{}", FloatTableHead());
  for (const FloatEnd& row : results.float_ends) text += FloatTableRow(row);
  if (!results.rivalries.empty()) text += fmt::format("\n{}", RivalTableHead());
  for (const Rivalry& row : results.rivalries) text += RivalTableRow(row);
  return text;
}

/// After every case, so that an interruption costs no more than one.
void WriteTables(const std::filesystem::path& out, const std::string& table, const Results& results) {
  WriteWholeFile(out / "accuracy.txt", table + Comparisons(results));
  WriteWholeFile(out / "accuracy.csv", SummariesAsCsv(results.summaries));
  WriteWholeFile(out / "precision.csv", FloatEndsAsCsv(results.float_ends));
  if (!results.rivalries.empty()) WriteWholeFile(out / "rivals.csv", RivalriesAsCsv(results.rivalries));
}

}  // namespace

ExitCode BenchAccuracy(const BenchOptions& options) {
  Protocol table(Head(options) + SummaryTableHead());
  Results results;
  for (const VerificationCase& of : AllVerificationCases()) {
    const bool named = std::ranges::find(options.cases, of.name) != options.cases.end();
    if (!of.in_bench || (!named && !options.cases.empty())) continue;
    if (!BenchCase(of, options, table, results)) return ExitCode::kInterrupted;
    WriteTables(options.out, table.Text(), results);
  }
  table.Add(Comparisons(results));
  return ExitCode::kDone;
}

}  // namespace sph
