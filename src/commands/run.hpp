// `sphlab run`: a scene without a picture.
#pragma once

#include <optional>
#include <string>

#include "base/error.hpp"
#include "commands/options.hpp"

namespace sph {

struct RunOptions {
  CommonOptions common;
  std::optional<double> until;   ///< [s]; default: the scene's
  std::optional<long> steps;     ///< instead of `until`
  std::string csv;               ///< file of time series; none if empty
  double every = 0;              ///< simulated time between its rows [s]; 0: every step
  std::string checkpoint;        ///< file that the run is saved in; none if empty
  double checkpoint_every = 10;  ///< wall time between two savings [s]
  std::string restart;           ///< checkpoint to go on from; none if empty
  bool scene_given = false;      ///< else a restart's scene is the saved one
};

ExitCode RunScene(const RunOptions& options);

}  // namespace sph
