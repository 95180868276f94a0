// `sphlab render`: a scene as PNG frames, without a display.
#pragma once

#include <optional>
#include <string>

#include "base/error.hpp"
#include "commands/options.hpp"

namespace sph {

struct RenderOptions {
  CommonOptions common;
  std::string out = "frames";    ///< folder of frame_000000.png, frame_000001.png, ...
  std::optional<long> frames;    ///< how many at most; default: up to `until`
  double fps = 30;               ///< frames per simulated second
  std::optional<double> until;   ///< [s]; default: the scene's, or where `frames` end
  std::string size = "960x960";  ///< WIDTHxHEIGHT [pixels]
  std::string backend = "auto";
};

ExitCode RenderScene(const RenderOptions& options);

}  // namespace sph
