// `sphlab bench speed`: what a particle and step costs here, as a table, a CSV file and a plot.
#pragma once

#include <string>

#include "base/error.hpp"

namespace sph {

struct BenchOptions {
  std::string out;     ///< folder of speed.csv, speed.png and speed.txt
  bool quick = false;  ///< small systems only
};

ExitCode BenchSpeed(const BenchOptions& options);

}  // namespace sph
