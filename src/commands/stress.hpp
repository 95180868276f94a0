// `sphlab stress`: the stability tests as a table or as JSON, their maps and plots as files.
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "lab/stress.hpp"

namespace sph {

struct StressCommand {
  std::vector<std::string> tests;  ///< by name; empty: all
  std::string out;                 ///< folder of plots and tables; empty: none are made
  bool json = false;
  StressOptions options;
};

/// kDone only if every row holds its bar. UsageError for a test that is not there.
ExitCode Stress(const StressCommand& command);

}  // namespace sph
