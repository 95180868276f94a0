#include "scenes/request.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/scene_checks.hpp"
#include "scenes/scene_file.hpp"

namespace sph {

Scene LoadScene(const SceneRequest& request) {
  std::vector<std::string> settings = request.settings;
  if (request.solver) settings.push_back("solver='" + *request.solver + "'");
  if (request.precision) settings.push_back("method.precision='" + *request.precision + "'");
  Scene scene = ReadScene(FindScene(request.scene), settings);
  if (request.particles) {
    ScaleToParticles(scene, *request.particles);
    CheckWhole(scene, fmt::format("--particles {}", *request.particles));  // fewer are larger, and may not fit
  }
  if (request.seed) scene.base.seed = *request.seed;
  scene.base.threads = request.threads;
  for (const std::string& warning : scene.warnings) fmt::print(stderr, "sphlab: {}\n", warning);
  return scene;
}

void TransferRequest(Archive& archive, SceneRequest& request) {
  archive(request.scene, request.settings, request.solver, request.precision, request.particles, request.seed,
          request.threads);
  if (!archive.Reading() || !request.particles) return;
  Archive::Require(*request.particles >= 1 && *request.particles <= kMostParticles);
}

}  // namespace sph
