#include "commands/command_line.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>

#include "base/nearest_name.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

/// A solver's name; the nearest one is named otherwise.
CLI::Validator SolverName() {
  return {[](std::string& name) {
            if (FindSolver(name) != nullptr) return std::string();
            std::vector<std::string> names;
            std::string all;
            for (const Solver& solver : AllSolvers()) {
              names.push_back(solver.name);
              all += " " + solver.name;
            }
            return fmt::format("unknown solver '{}'.{} The solvers are:{}", name, DidYouMean(name, names), all);
          },
          "NAME"};
}

}  // namespace

CLI::Validator WholeNumber(std::uint64_t least, std::uint64_t greatest) {
  return {[least, greatest](std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [rest, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && rest == end && value >= least && value <= greatest) return std::string();
            return fmt::format("'{}' is not a whole number from {} to {}", text, least, greatest);
          },
          fmt::format("{} to {}", least, greatest)};
}

CLI::Validator FinitePositive() {
  return {[](std::string& text) {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0) return std::string();
            return fmt::format("'{}' is not a finite number > 0", text);
          },
          "NUMBER > 0"};
}

void AddSceneOptions(CLI::App& command, SceneRequest& request) {
  command.add_option("SCENE", request.scene, "a scene's name, or a path to a .toml file")->capture_default_str();
  command.add_option("--set", request.settings, "KEY=VALUE: a scene key, dotted; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--solver", request.solver, "the method, in place of the scene's")->check(SolverName());
  command.add_option("--precision", request.precision, "of the passes over neighbours: float or double")
      ->check(CLI::IsMember({"float", "double"}));
  command.add_option("--particles", request.particles, "the same fluid with that many particles")
      ->check(WholeNumber(1, kMostParticles));
  command.add_option("--seed", request.seed, "of the random start")->check(WholeNumber(0, UINT64_MAX));
  command.add_option("--threads", request.threads, "0 for one a processor")->check(WholeNumber(0, 1024));
}

void AddOutputOptions(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "results as one JSON value");
  command.add_flag("--quiet", options.quiet, "no progress, no summary");
}

void AddKeysOption(CLI::App& command, CommonOptions& options) {
  command.add_option("--keys", options.keys, "T:KEY,T:KEY: keys pressed at simulated times; T:KEY:SECONDS held");
}

}  // namespace sph
