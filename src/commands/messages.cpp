#include "commands/messages.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace sph {

void PassOnMessage(Session& session, bool quiet) {
  if (!session.message.empty() && !quiet) {
    fmt::print(stderr, "t = {:.6g} s: {}\n", session.System().Time(), session.message);
  }
  session.message.clear();
}

}  // namespace sph
