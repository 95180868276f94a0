// Scenes that nobody has thought of: random values for random keys of the whole table of scene keys.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sph {

/// A scene file. Every second one that can be read at all is a catalogue's scene with a few keys set anew; the others
/// are made from nothing. Same seed, same text. What it says may be refused by the loader.
struct RandomScene {
  std::string base;                   ///< a scene of the catalogue; empty: none
  std::string text;                   ///< if there is no base
  std::vector<std::string> settings;  ///< "KEY=VALUE", on top
};

RandomScene MakeRandomScene(std::uint64_t seed);

/// For messages: a command line, or the file's text.
std::string Describe(const RandomScene& scene);

}  // namespace sph
