// Scenes that nobody has thought of: such as people write, and random values for random keys of the whole table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sph {

/// A scene file: a plausible one, a catalogue's scene with a few keys set anew, or one of random keys, which the loader
/// mostly refuses. Same seed, same text.
struct RandomScene {
  std::string base = {};                   ///< a scene of the catalogue; empty: none
  std::string text = {};                   ///< if there is no base
  std::vector<std::string> settings = {};  ///< "KEY=VALUE", on top
};

RandomScene MakeRandomScene(std::uint64_t seed);

/// For messages: a command line, or the file's text.
std::string Describe(const RandomScene& scene);

}  // namespace sph
