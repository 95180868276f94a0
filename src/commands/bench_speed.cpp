// `sphlab bench speed`: what a particle and step costs here, and what leaving out saves.
#include <filesystem>

#include "commands/bench.hpp"
#include "commands/bench_protocol.hpp"
#include "commands/interrupt.hpp"
#include "io/png.hpp"
#include "io/whole_file.hpp"
#include "lab/skips_report.hpp"
#include "lab/speed_report.hpp"

namespace sph {
namespace {

/// The table of run times; false if it was interrupted.
bool WriteSpeeds(const std::filesystem::path& out, bool quick, const std::string& machine) {
  const RatesOfThreads rates = MeasureVectorRates();
  Protocol table(machine + DescribeLimit(rates) + "\n" + SpeedTableHead());
  std::vector<SpeedResult> results;
  for (const SpeedCase& of : SpeedCases(quick)) {
    if (Interrupted()) return false;
    for (const SpeedResult& result : MeasureSpeed(of, rates)) {
      table.Add(SpeedTableRow(result));
      results.push_back(result);
    }
  }
  WriteWholeFile(out / "speed.csv", SpeedAsCsv(results));
  WriteWholeFile(out / "speed.txt", table.Text());
  WritePng(out / "speed.png", Draw(SpeedPlot(results)));
  return true;
}

/// The table of what leaving out saves; false if it was interrupted.
bool WriteSkips(const std::filesystem::path& out, bool quick, const std::string& machine) {
  const std::size_t particles = quick ? 10'000 : 100'000;
  const int repetitions = quick ? 3 : 9;
  fmt::print("\n");
  Protocol table(machine + SkipsTableHead());
  std::vector<SkipResult> results;
  for (const auto& make : SkipComparisons(particles)) {
    if (Interrupted()) return false;
    results.push_back(Measure(make(), repetitions));
    table.Add(SkipsTableRow(results.back()));
  }
  WriteWholeFile(out / "skips.csv", SkipsAsCsv(results));
  WriteWholeFile(out / "skips.txt", table.Text());
  return true;
}

}  // namespace

ExitCode BenchSpeed(const BenchOptions& options) {
  const std::string machine = DescribeMachine();
  const bool whole =
      WriteSpeeds(options.out, options.quick, machine) && WriteSkips(options.out, options.quick, machine);
  return whole ? ExitCode::kDone : ExitCode::kInterrupted;
}

}  // namespace sph
