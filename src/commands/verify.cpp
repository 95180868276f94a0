#include "commands/verify.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "base/nearest_name.hpp"
#include "commands/interrupt.hpp"
#include "lab/verification.hpp"
#include "scenes/build.hpp"

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

}  // namespace

ExitCode Verify(const VerifyOptions& options) {
  const auto cases = Chosen(options);
  CatchInterrupts();
  constexpr const char* kRow = "{:<16} {:<7} {:>6}  {:<54} {:>10} {:>8}  {:<5} {:>7}  {}\n";
  if (!options.json) {
    fmt::print(kRow, "case", "solver", "N", "metric", "value", "bar", "", "seconds", "reference");
  }
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  bool all_hold = true;
  for (const VerificationCase* of : cases) {
    if (Interrupted()) return ExitCode::kInterrupted;
    SceneRequest request = of->request;
    request.threads = options.threads;
    const Scene scene = LoadScene(request);
    const auto system = MakeSystem(scene);
    const Stopwatch watch;
    const std::vector<Verdict> verdicts = of->measure(*system);
    const double seconds = watch.Seconds();
    for (const Verdict& verdict : verdicts) {
      all_hold = all_hold && verdict.Holds();
      if (options.json) {
        report.push_back({{"case", of->name},
                          {"solver", scene.solver},
                          {"particles", system->State().Size()},
                          {"metric", verdict.metric},
                          {"value", verdict.value},
                          {"bar", verdict.bar},
                          {"holds", verdict.Holds()},
                          {"reference", verdict.reference},
                          {"wall_seconds", seconds}});
      } else {
        fmt::print(kRow, of->name, scene.solver, system->State().Size(), verdict.metric,
                   fmt::format("{:.4g}", verdict.value), fmt::format("{:.2g}", verdict.bar),
                   verdict.Holds() ? "holds" : "open", fmt::format("{:.1f}", seconds), verdict.reference);
        std::fflush(stdout);
      }
    }
  }
  if (options.json) fmt::print("{}\n", report.dump(2));
  return all_hold ? ExitCode::kDone : ExitCode::kTrouble;
}

}  // namespace sph
