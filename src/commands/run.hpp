// `sphlab run`: a scene without a picture.
#pragma once

#include <optional>
#include <string>

#include "base/error.hpp"
#include "commands/options.hpp"

namespace sph {

struct RunOptions {
  CommonOptions common;
  std::optional<double> until;  ///< [s]; default: the scene's
  std::optional<long> steps;    ///< instead of `until`
  std::string csv;              ///< file of time series; none if empty
  double every = 0;             ///< simulated time between its rows [s]; 0: every step
};

ExitCode RunScene(const RunOptions& options);

}  // namespace sph
