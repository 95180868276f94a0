// A scene file (TOML) read and checked.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scenes/scene.hpp"

namespace sph {

/// The scene that `path` describes, with each of `settings` ("KEY=VALUE", dotted keys as in the file; walls by name:
/// wall.dam.at=0.5) applied after the file. Unknown keys, wrong types and impossible values throw UsageError with file,
/// line, column, what is accepted and the nearest name; an unreadable file throws TroubleError.
Scene ReadScene(const std::filesystem::path& path, std::span<const std::string> settings = {});

/// The same of a text; messages name it `source`.
Scene ParseScene(const std::string& text, const std::string& source, std::span<const std::string> settings = {});

/// Sets one key of a scene that is running. UsageError if the key may not change then.
void SetWhileRunning(Scene& scene, const std::string& key, double value);

}  // namespace sph
