// The options that several commands share, as the command line takes them.
#pragma once

#include <CLI/CLI.hpp>

#include "commands/options.hpp"

namespace sph {

/// Scene (positional), --set, --solver, --particles, --seed, --threads.
void AddSceneOptions(CLI::App& command, SceneRequest& request);
/// --json, --quiet.
void AddOutputOptions(CLI::App& command, CommonOptions& options);
/// --keys.
void AddKeysOption(CLI::App& command, CommonOptions& options);

/// Accepts finite numbers > 0 only.
CLI::Validator FinitePositive();

}  // namespace sph
