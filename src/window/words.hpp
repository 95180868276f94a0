// What the window says in words: status line, help table, title.
#pragma once

#include <string>
#include <vector>

#include "render/text.hpp"
#include "window/rate_meter.hpp"
#include "window/session.hpp"

namespace sph {

/// Scene, number of particles, time, step, and how fast it goes: "dam-break  N 600  t 1.23 s  step 307  ...".
std::string StatusLine(const Session& session, const Rates& rates);

/// What must stay on the screen: why the simulation has stopped, and what to do. Empty if all is well.
std::string StandingMessage(const Session& session);

/// A row for every control, in the order of the table, in the words of the scene where it gives a key a meaning of its
/// own; then the scene's other keys.
std::vector<HelpRow> HelpRows(const Session& session);

std::string WindowTitle(const Session& session);

}  // namespace sph
