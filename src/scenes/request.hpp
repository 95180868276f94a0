// What a command line asks for: a scene, and what of it shall be different.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "scenes/scene.hpp"

namespace sph {

struct SceneRequest {
  std::string scene = "dam-break";    ///< a name in the catalogue, or a path to a .toml file
  std::vector<std::string> settings;  ///< "KEY=VALUE"
  std::optional<std::string> solver;
  std::optional<std::string> precision;  ///< "float" or "double"
  std::optional<std::size_t> particles;  ///< rescales the scene, see ScaleToParticles
  std::optional<std::uint64_t> seed;
  int threads = 0;  ///< 0: as many as there are processors
};

/// TroubleError where what is read asks for a number of particles that --particles refuses.
void TransferRequest(Archive& archive, SceneRequest& request);

/// The scene with the request's changes. UsageError or TroubleError as ReadScene and FindScene say.
Scene LoadScene(const SceneRequest& request);

}  // namespace sph
