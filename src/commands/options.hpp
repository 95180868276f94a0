// What several commands are asked for.
#pragma once

#include <string>

#include "scenes/request.hpp"

namespace sph {

struct CommonOptions {
  SceneRequest request;
  std::string keys;    ///< a key script
  bool json = false;   ///< results as one JSON value
  bool quiet = false;  ///< no progress, no summary
};

}  // namespace sph
