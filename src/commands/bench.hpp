// `sphlab bench speed`: what a particle and step costs here, and what leaving out saves: tables, CSV files and a plot.
#pragma once

#include <string>

#include "base/error.hpp"

namespace sph {

struct BenchOptions {
  std::string out;     ///< folder of speed.csv, speed.txt, speed.png, skips.csv and skips.txt
  bool quick = false;  ///< small systems only
};

ExitCode BenchSpeed(const BenchOptions& options);

}  // namespace sph
