#include "commands/bench.hpp"

#include <algorithm>

#include "base/nearest_name.hpp"
#include "commands/interrupt.hpp"
#include "io/output_directory.hpp"
#include "lab/pysph.hpp"
#include "lab/verification.hpp"

namespace sph {
namespace {

constexpr const char* kSpeed = "speed";

void CheckNames(const std::vector<std::string>& cases) {
  std::vector<std::string> names = {kSpeed};
  for (const VerificationCase& of : AllVerificationCases()) {
    if (of.in_bench) names.push_back(of.name);
  }
  for (const std::string& name : cases) {
    if (std::ranges::find(names, name) != names.end()) continue;
    throw UsageError("bench: unknown case '{}'.{} There are: {}", name, DidYouMean(name, names),
                     fmt::join(names, ", "));
  }
}

}  // namespace

ExitCode Bench(const BenchOptions& options) {
  CheckNames(options.cases);
  if (options.peers) RequirePySph();
  CatchInterrupts();
  PrepareOutputDirectory(options.out);
  BenchOptions accuracy = options;
  const bool speed = std::erase(accuracy.cases, kSpeed) > 0;
  if (speed) {
    const ExitCode code = BenchSpeed(options);
    if (code != ExitCode::kDone || accuracy.cases.empty()) return code;
  }
  return BenchAccuracy(accuracy);
}

}  // namespace sph
