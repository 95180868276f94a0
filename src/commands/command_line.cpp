#include "commands/command_line.hpp"

#include <charconv>
#include <cmath>

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

/// Digits only: CLI11 would take -1 for the largest number.
CLI::Validator WholeNumber() {
  return {[](std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [rest, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && rest == end) return std::string();
            return fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
          },
          "NUMBER"};
}

}  // namespace

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
      ->check(CLI::Range(std::size_t{1}, kMostParticles));
  command.add_option("--seed", request.seed, "of the random start")->check(WholeNumber());
  command.add_option("--threads", request.threads, "0 for one a processor")->check(CLI::Range(0, 1024));
}

void AddOutputOptions(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "results as one JSON value");
  command.add_flag("--quiet", options.quiet, "no progress, no summary");
}

void AddKeysOption(CLI::App& command, CommonOptions& options) {
  command.add_option("--keys", options.keys, "T:KEY,T:KEY: keys pressed at simulated times; T:KEY:SECONDS held");
}

}  // namespace sph
