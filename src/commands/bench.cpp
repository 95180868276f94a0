#include "commands/bench.hpp"

#include <fmt/chrono.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "commands/interrupt.hpp"
#include "io/output_directory.hpp"
#include "io/png.hpp"
#include "io/whole_file.hpp"
#include "lab/skips_report.hpp"
#include "lab/speed_report.hpp"

namespace sph {
namespace {

/// "model name" of /proc/cpuinfo.
std::string Processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  }
  return "unknown processor";
}

/// The settings of OpenMP in the environment, as a line; empty if there are none.
std::string ThreadSettings() {
  std::string settings;
  for (const char* name : {"OMP_WAIT_POLICY", "OMP_PROC_BIND", "OMP_PLACES"}) {
    if (const char* value = std::getenv(name))
      settings += fmt::format("{}{}={}", settings.empty() ? "" : " ", name, value);
  }
  return settings.empty() ? "" : settings + "\n";
}

/// Processor, compiler, flags, settings of threads, and date.
std::string DescribeMachine() {
  const std::time_t now = std::time(nullptr);
  return fmt::format("{}, {} processors\ncompiled by {} {} with {}\n{}{:%Y-%m-%d}\n\n", Processor(),
                     std::thread::hardware_concurrency(), SPHLAB_COMPILER, __VERSION__, SPHLAB_FLAGS, ThreadSettings(),
                     fmt::gmtime(now));
}

/// A table that is seen while it grows.
class Protocol {
 public:
  explicit Protocol(const std::string& head) { Add(head); }
  void Add(const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
    text_ += text;
  }
  const std::string& Text() const { return text_; }

 private:
  std::string text_;
};

/// The table of run times; false if it was interrupted.
bool WriteSpeeds(const std::filesystem::path& out, bool quick, const std::string& machine) {
  const VectorRates rates = MeasureVectorRates();
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
  CatchInterrupts();
  PrepareOutputDirectory(options.out);
  const std::string machine = DescribeMachine();
  const bool whole =
      WriteSpeeds(options.out, options.quick, machine) && WriteSkips(options.out, options.quick, machine);
  return whole ? ExitCode::kDone : ExitCode::kInterrupted;
}

}  // namespace sph
