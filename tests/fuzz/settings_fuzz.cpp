// Any lines as --set options of scenes of every solver.
#include "fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sph;
  for (const char* scene : {"dam-break", "mueller", "still-water"}) {
    SceneRequest request;
    request.scene = scene;
    request.threads = 1;
    request.settings = {"fluid.particles=50"};
    std::istringstream lines(TextOf(data, size));
    for (std::string line; std::getline(lines, line);) request.settings.push_back(line);
    RefusalIsFine([&] { StepIfSmall(LoadScene(request)); });
  }
  return 0;
}
