#include "scenes/scene_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "scenes/scene_checks.hpp"
#include "scenes/scene_keys.hpp"
#include "scenes/value.hpp"

namespace sph {
namespace {

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || std::filesystem::is_directory(path) || !(text << file.rdbuf())) {
    throw TroubleError("cannot read the scene file '{}': {}", path.string(),
                       std::filesystem::is_directory(path) ? "it is a directory" : std::strerror(errno));
  }
  return text.str();
}

template <typename Key>
std::vector<std::string> Names(std::span<const Key> keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) names.push_back(key.name);
  return names;
}

/// Applies the leaves of `table` to `scene`, `prefix` being the dotted path so far, and notes which keys were given.
class SceneReader {
 public:
  SceneReader(Scene& scene, std::string source) : scene_(scene), source_(std::move(source)) {}

  void Read(const toml::table& table, const std::string& prefix = "") {
    for (const auto& [name, node] : table) {
      const std::string path = prefix + std::string(name.str());
      if (path == "wall") {
        ReadWalls(node);
      } else if (path == "key") {
        ReadControls(node);
      } else if (const SceneKey* key = FindSceneKey(path)) {
        key->apply(scene_, Value(node, path, source_));
        given_.insert(path);
      } else if (node.is_table() && IsPrefix(path + ".")) {
        Read(*node.as_table(), path + ".");
      } else {
        auto names = Names(AllSceneKeys());
        names.insert(names.end(), {"wall", "key"});
        throw UsageError("{}: unknown key '{}'.{}", Place(node), path, DidYouMean(path, names));
      }
    }
  }

  /// UsageError naming the first required key that was not given.
  void CheckComplete() const {
    for (const SceneKey& key : AllSceneKeys()) {
      if (key.required && !given_.contains(key.name)) {
        throw UsageError("{}: the key '{}' is missing ({})", source_, key.name, key.what);
      }
    }
  }

 private:
  static bool IsPrefix(const std::string& prefix) {
    const auto keys = AllSceneKeys();
    return std::any_of(keys.begin(), keys.end(), [&](const SceneKey& key) { return key.name.starts_with(prefix); });
  }

  std::string Place(const toml::node& node) const { return Value(node, "", source_).Place(); }

  /// Calls read(key, value) for the entries of one table of an array of tables, in the order of `keys`.
  template <typename Key, typename Read>
  void ReadEntries(const toml::table& table, const std::string& prefix, std::span<const Key> keys, Read read) const {
    const auto names = Names(keys);
    for (const auto& [name, node] : table) {
      if (std::find(names.begin(), names.end(), name.str()) == names.end()) {
        throw UsageError("{}: unknown key '{}.{}'.{}", Place(node), prefix, name.str(), DidYouMean(name.str(), names));
      }
    }
    for (const Key& key : keys) {
      if (const toml::node* node = table.get(key.name)) {
        read(key, Value(*node, prefix + "." + key.name, source_));
      } else if (key.required) {
        throw UsageError("{}: the key '{}.{}' is missing ({})", Place(table), prefix, key.name, key.what);
      }
    }
  }

  const toml::array& Tables(const toml::node& node, const std::string& name) const {
    const auto* array = node.as_array();
    if (array == nullptr || !array->is_array_of_tables()) {
      throw UsageError("{}: {} takes tables, each under its own [[{}]]", Place(node), name, name);
    }
    return *array;
  }

  void ReadWalls(const toml::node& node) {
    if (const auto* by_name = node.as_table(); by_name != nullptr && source_.starts_with("--")) {
      SetWalls(*by_name);
      return;
    }
    for (const toml::node& element : Tables(node, "wall")) {
      Wall wall;
      ReadEntries(*element.as_table(), "wall", AllWallKeys(),
                  [&](const WallKey& key, const Value& value) { key.apply(scene_, wall, value); });
      if (FindWall(scene_.base.walls, wall.name) != nullptr) {
        throw UsageError("{}: there are two walls named '{}'", Place(element), wall.name);
      }
      scene_.base.walls.push_back(wall);
    }
  }

  /// --set wall.NAME.KEY=VALUE
  void SetWalls(const toml::table& by_name) {
    for (const auto& [name, node] : by_name) {
      Wall* wall = FindWall(scene_.base.walls, name.str());
      if (wall == nullptr || !node.is_table()) {
        throw UsageError("{}: no wall '{}' in this scene.{}", Place(node), name.str(),
                         DidYouMean(name.str(), Names(std::span<const Wall>(scene_.base.walls))));
      }
      for (const auto& [entry, value] : *node.as_table()) {
        const auto keys = AllWallKeys();
        const auto key =
            std::find_if(keys.begin(), keys.end(), [&](const WallKey& k) { return k.name == entry.str(); });
        if (key == keys.end()) {
          throw UsageError("{}: unknown key 'wall.{}.{}'.{}", Place(value), name.str(), entry.str(),
                           DidYouMean(entry.str(), Names(keys)));
        }
        key->apply(scene_, *wall, Value(value, fmt::format("wall.{}.{}", name.str(), entry.str()), source_));
      }
    }
  }

  void ReadControls(const toml::node& node) {
    for (const toml::node& element : Tables(node, "key")) {
      SceneControl control;
      ReadEntries(*element.as_table(), "key", AllControlKeys(),
                  [&](const ControlKey& key, const Value& value) { key.apply(control, value); });
      scene_.controls.push_back(control);
    }
  }

  Scene& scene_;
  std::string source_;
  std::set<std::string, std::less<>> given_;
};

/// "a.b=3" as a table. A value that is not TOML is taken as a text, so that names need no quotes.
toml::table ParseSetting(const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set {}: it takes KEY=VALUE, such as forces.damping=0.5", setting);
  }
  const std::string key = setting.substr(0, equals);
  const std::string value = setting.substr(equals + 1);
  try {
    return toml::parse(key + " = " + value);
  } catch (const toml::parse_error&) {
    try {
      toml::table quoted = toml::parse(key + " = ''");
      toml::node* leaf = &quoted;
      while (leaf->is_table()) leaf = &leaf->as_table()->begin()->second;
      *leaf->as_string() = value;
      return quoted;
    } catch (const toml::parse_error& error) {
      throw UsageError("--set {}: {}", setting, error.description());
    }
  }
}

}  // namespace

Scene ReadScene(const std::filesystem::path& path, std::span<const std::string> settings) {
  const std::string text = ReadText(path);
  Scene scene;
  scene.name = path.stem().string();
  const std::string source = path.string();
  SceneReader reader(scene, source);
  try {
    reader.Read(toml::parse(text, source));
  } catch (const toml::parse_error& error) {
    throw UsageError("{}:{}:{}: {}", source, error.source().begin.line, error.source().begin.column,
                     error.description());
  }
  reader.CheckComplete();
  for (const std::string& setting : settings) SceneReader(scene, "--set").Read(ParseSetting(setting));
  CheckWhole(scene, source);
  return scene;
}

void SetWhileRunning(Scene& scene, const std::string& key, double number) {
  const SceneKey* found = FindSceneKey(key);
  if (found == nullptr || found->when != When::kAnyTime) {
    std::vector<std::string> names;
    for (const SceneKey& k : AllSceneKeys()) {
      if (k.when == When::kAnyTime) names.push_back(k.name);
    }
    throw UsageError("{}: '{}' {}.{}", scene.name, key,
                     found == nullptr ? "is not a scene key" : "cannot be set while the scene runs",
                     DidYouMean(key, names));
  }
  const toml::value<double> node(number);
  found->apply(scene, Value(node, key, "--set"));
}

}  // namespace sph
