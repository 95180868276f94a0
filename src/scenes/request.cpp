#include "scenes/request.hpp"

#include "scenes/build.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/scene_file.hpp"

namespace sph {

Scene LoadScene(const SceneRequest& request) {
  std::vector<std::string> settings = request.settings;
  if (request.solver) settings.push_back("solver='" + *request.solver + "'");
  if (request.precision) settings.push_back("method.precision='" + *request.precision + "'");
  Scene scene = ReadScene(FindScene(request.scene), settings);
  if (request.particles) ScaleToParticles(scene, *request.particles);
  if (request.seed) scene.base.seed = *request.seed;
  scene.base.threads = request.threads;
  return scene;
}

}  // namespace sph
