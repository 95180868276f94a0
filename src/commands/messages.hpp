// What there is to say before and while a scene runs, on stderr; without `quiet` only.
#pragma once

#include "window/session.hpp"

namespace sph {

/// Says how many particles there are, if that is not the number asked for.
void NotePlacement(const Scene& scene, bool quiet);

/// Prints and clears the session's message.
void PassOnMessage(Session& session, bool quiet);

}  // namespace sph
