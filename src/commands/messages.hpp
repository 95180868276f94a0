// What a scripted key had to say, on stderr.
#pragma once

#include "window/session.hpp"

namespace sph {

/// Prints and clears the session's message; without `quiet` only.
void PassOnMessage(Session& session, bool quiet);

}  // namespace sph
