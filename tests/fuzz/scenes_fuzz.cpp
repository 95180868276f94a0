// Any bytes as a scene file: read, or refused as the user's error. A small scene that is accepted makes a step.
#include "fuzz/fuzz.hpp"
#include "io/whole_file.hpp"
#include "scenes/scene_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sph;
  static const ScratchDirectory scratch;
  const auto file = scratch.Path() / "scene.toml";
  std::ofstream(file, std::ios::binary) << TextOf(data, size);
  RefusalIsFine([&] { StepIfSmall(ReadScene(file)); });
  return 0;
}
