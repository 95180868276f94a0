// `sphlab bench`: run time against error of the verification cases, and what a particle and step costs: tables, CSV
// files and plots.
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

namespace sph {

struct BenchOptions {
  std::vector<std::string> cases;  ///< "speed", and names of verification cases; empty: all of these
  std::string out;                 ///< folder of the files
  bool quick = false;              ///< small systems only
  bool peers = false;              ///< PySPH beside the cases that it has examples of
  double longest = 5;              ///< a run of a case that would take longer is left out [s]
  int threads = 1;                 ///< of the cases; speed has its own
};

/// UsageError for a case that is not there; TroubleError if PySPH is wanted and is not there.
ExitCode Bench(const BenchOptions& options);

// Its two parts.
ExitCode BenchSpeed(const BenchOptions& options);
ExitCode BenchAccuracy(const BenchOptions& options);

}  // namespace sph
