// A verification case at several resolutions.
#pragma once

#include <vector>

#include "lab/judge_levels.hpp"
#include "lab/verification.hpp"

namespace sph {

struct LadderOptions {
  bool whole = false;  ///< all resolutions of a case, not only two
  int threads = 0;     ///< 0: as many as there are processors
};

/// What a case's runs came to.
struct CaseResult {
  std::string solver;
  std::size_t particles = 0;  ///< of the case's own resolution, as placed
  double seconds = 0;         ///< of that run alone, the start left out
  std::vector<Judged> metrics = {};
};

/// Numbers of particles to run a case with, from coarse to fine: those of its shares, or the last two up to its own N
/// unless the ladder shall be whole. Where N fills a box with whole rows and columns, so do the others, as near as can
/// be.
std::vector<std::size_t> LadderOf(const VerificationCase& of, bool whole);

/// The scene of a case, with that many particles.
Scene SceneOf(const VerificationCase& of, std::size_t particles, int threads);

/// Runs a case with N particles, and with those of the ladder if it has metrics that are judged by it.
CaseResult RunCase(const VerificationCase& of, const LadderOptions& options);

}  // namespace sph
