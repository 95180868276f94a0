#include "commands/messages.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "scenes/build.hpp"

namespace sph {

void NotePlacement(const Scene& scene, bool quiet) {
  if (quiet || Fitted(scene.base.fluid).particles == scene.base.fluid.particles) return;
  fmt::print(stderr, "sphlab: {}: {}\n", scene.name, DescribePlacement(scene));
}

void PassOnMessage(Session& session, bool quiet) {
  if (!session.message.empty() && !quiet) {
    fmt::print(stderr, "t = {:.6g} s: {}\n", session.System().Time(), session.message);
  }
  session.message.clear();
}

}  // namespace sph
