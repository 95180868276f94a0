// Which scenes there are, and where their files lie.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sph {

/// The folder of data files that the program was built beside, or $SPHLAB_ASSETS if that is set.
std::filesystem::path AssetsFolder();

/// The names of the scenes in assets/scenes, in alphabetical order. TroubleError if the folder cannot be read.
std::vector<std::string> SceneNames();

/// The file of a scene: the path itself if it ends in .toml, else the scene of that name. UsageError names the nearest
/// scene.
std::filesystem::path FindScene(const std::string& name_or_path);

}  // namespace sph
