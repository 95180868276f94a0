#include "commands/bench.hpp"

#include <filesystem>
#include <fstream>

#include "commands/interrupt.hpp"
#include "io/output_directory.hpp"
#include "io/png.hpp"
#include "io/whole_file.hpp"
#include "lab/speed.hpp"

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

}  // namespace

ExitCode BenchSpeed(const BenchOptions& options) {
  CatchInterrupts();
  PrepareOutputDirectory(options.out);
  std::vector<SpeedResult> results;
  const std::string head =
      fmt::format("{:>9} {:>7} {:>6} {:>8} {:>5} {:>8} {:>8} {:>8} {:>7} {:>6} {:>9} {:>9}\n", "particles", "threads",
                  "", "set", "lists", "least ns", "median", "slowest", "M/s", "bytes", "rho error", "acc error");
  std::string table = fmt::format("{}\ncompiled by {} with {}\n\n{}", Processor(), __VERSION__, SPHLAB_FLAGS, head);
  fmt::print("{}", table);
  for (const SpeedCase& of : SpeedCases(options.quick)) {
    if (Interrupted()) break;
    const SpeedResult r = MeasureSpeed(of);
    results.push_back(r);
    const std::string row =
        fmt::format("{:>9} {:>7} {:>6} {:>8} {:>5} {:>8.2f} {:>8.2f} {:>8.2f} {:>7.2f} {:>6.0f} {:>9.1e} {:>9.1e}\n",
                    of.particles, of.threads, of.precision == Precision::kFloat ? "float" : "double",
                    of.instruction_set, of.keep_lists ? "kept" : "anew", r.least_ns, r.median_ns, r.greatest_ns,
                    1e3 / r.least_ns, r.bytes, r.density_error, r.acceleration_error);
    fmt::print("{}", row);
    std::fflush(stdout);
    table += row;
  }
  const std::filesystem::path out = options.out;
  WriteWholeFile(out / "speed.csv", SpeedAsCsv(results));
  WriteWholeFile(out / "speed.txt", table);
  WritePng(out / "speed.png", Draw(SpeedPlot(results)));
  return Interrupted() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace sph
