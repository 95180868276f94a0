// PySPH on the same flows, measured on the same machine: its examples run by its own Python, judged as our runs are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/verification.hpp"

namespace sph {

/// What another program reached in a case.
struct RivalRun {
  std::string case_name;
  std::string who;  ///< program, version, method
  std::size_t particles = 0;
  double seconds = 0;               ///< processor time of its solver
  std::vector<double> errors = {};  ///< one a metric of the case, as those of our runs
};

/// The Python that PySPH is looked for in: $SPHLAB_PYTHON, or Debian's.
std::string PythonForPySph();

/// TroubleError, naming the Debian package to install, unless that Python has PySPH.
void RequirePySph();

/// The resolutions [particles along the flow; 0: the example's own] at which PySPH runs a case; none where it has no
/// example of the same flow.
std::vector<int> PySphResolutions(const std::string& case_name);

/// Runs PySPH's example of the case in a process of its own, on one thread: first a few steps, so that it has compiled
/// what it needs, then all. What it says goes to a file in `folder`, which TroubleError names if the run fails.
RivalRun RunPySph(const VerificationCase& of, int resolution, const std::filesystem::path& folder);

/// A file of assets/peers/pysph_run.py: the facts of its first lines, and the particles at each time.
struct PeerFile {
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<FlowSnapshot> snapshots;

  /// TroubleError if there is no such fact.
  const std::string& Fact(const std::string& key) const;
};
PeerFile ReadPeerFile(const std::filesystem::path& file);

}  // namespace sph
