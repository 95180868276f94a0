// Any text as --keys of a small dam break, and what is accepted is pressed.
#include "fuzz/fuzz.hpp"
#include "window/key_script.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sph;
  SceneRequest request;
  request.particles = 40;
  request.threads = 1;
  Session session(request);
  RefusalIsFine([&] {
    KeyScript keys(TextOf(data, size), session.CurrentScene());
    for (int step = 0; step < 10 && session.System().State().Size() < 3000; ++step) {
      keys.Play(session);
      if (session.StepUnlessPaused())
        Require(!session.System().Trouble() || !session.System().Trouble()->limit.empty());
    }
  });
  return 0;
}
