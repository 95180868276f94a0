// `sphlab verify`: the verification cases as a table or as JSON.
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

namespace sph {

struct VerifyOptions {
  std::vector<std::string> cases;  ///< by name; empty: all that are not slow
  bool all = false;                ///< the slow ones, too, and the finest resolution of each
  bool json = false;
  int threads = 0;
};

/// kDone only if every metric holds by the rule of its kind. A signal ends it at once: there is no file to be
/// completed. UsageError for a case that is not there.
ExitCode Verify(const VerifyOptions& options);

}  // namespace sph
