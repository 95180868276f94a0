// Any text as --keys of a small dam break, and what is accepted is pressed.
#include "fuzz/fuzz.hpp"
#include "window/key_script.hpp"

namespace {

/// A key that goes to another scene, some of which come to rest for minutes in a program like this one.
bool LeavesTheScene(const std::string& keys) {
  for (std::size_t colon = keys.find(':'); colon != std::string::npos; colon = keys.find(':', colon + 1)) {
    const std::size_t key = keys.find_first_not_of(" \t", colon + 1);
    if (key != std::string::npos && std::string("[]0123456789").find(keys[key]) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sph;
  SceneRequest request;
  request.particles = 40;
  request.threads = 1;
  Session session(request);
  RefusalIsFine([&] {
    KeyScript keys(TextOf(data, size), session.CurrentScene());
    if (LeavesTheScene(std::string(TextOf(data, size)))) return;
    for (int step = 0; step < 10 && session.System().State().Size() < 3000; ++step) {
      keys.Play(session);
      if (session.StepUnlessPaused())
        Require(!session.System().Trouble() || !session.System().Trouble()->limit.empty());
    }
  });
  return 0;
}
