// The options that several commands share, as the command line takes them.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

#include "commands/options.hpp"

namespace sph {

/// Scene (positional), --set, --solver, --particles, --seed, --threads.
void AddSceneOptions(CLI::App& command, SceneRequest& request);
/// --json, --quiet.
void AddOutputOptions(CLI::App& command, CommonOptions& options);
/// --keys.
void AddKeysOption(CLI::App& command, CommonOptions& options);

/// Accepts whole numbers within these, in digits only: CLI11 takes -1 for the largest number, and 1_000 from 2.4 on.
CLI::Validator WholeNumber(std::uint64_t least, std::uint64_t greatest);
/// Accepts finite numbers > 0 only.
CLI::Validator FinitePositive();

}  // namespace sph
