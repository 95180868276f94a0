// Scenes as people write them: sizes, speeds and steps that go together, and all the loader accepts.
#pragma once

#include <string>

#include "lab/dice.hpp"

namespace sph {

/// A scene file: a tank, a channel, vortices, a drop, a star, or a tank of the two documents' solvers.
std::string PlausibleScene(Dice& dice);

}  // namespace sph
