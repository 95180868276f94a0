#include "scenes/catalogue.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "base/error.hpp"
#include "base/nearest_name.hpp"

namespace sph {

std::filesystem::path AssetsFolder() {
  const char* set = std::getenv("SPHLAB_ASSETS");
  return set != nullptr && *set != '\0' ? set : SPHLAB_ASSETS;
}

std::vector<std::string> SceneNames() {
  const std::filesystem::path folder = AssetsFolder() / "scenes";
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".toml") names.push_back(entry->path().stem().string());
  }
  if (error) {
    throw TroubleError(
        "cannot list the scenes in '{}': {} (set SPHLAB_ASSETS to the folder assets/ of the source tree)",
        folder.string(), error.message());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::filesystem::path FindScene(const std::string& name_or_path) {
  if (name_or_path.ends_with(".toml")) return name_or_path;
  const std::vector<std::string> names = SceneNames();
  if (std::find(names.begin(), names.end(), name_or_path) == names.end()) {
    throw UsageError("unknown scene '{}'.{} There are: {}; or a path to a .toml file", name_or_path,
                     DidYouMean(name_or_path, names), fmt::join(names, ", "));
  }
  return AssetsFolder() / "scenes" / (name_or_path + ".toml");
}

}  // namespace sph
