#include "scenes/scene_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "scenes/method_rules.hpp"
#include "scenes/scene_checks.hpp"
#include "scenes/scene_keys.hpp"
#include "scenes/value.hpp"

namespace sph {
namespace {

std::string ReadText(const std::filesystem::path& path) {
  std::error_code ignored;  // what else is wrong with the path shows when it is opened
  const bool is_directory = std::filesystem::is_directory(path, ignored);
  std::ifstream file(path, std::ios::binary);
  constexpr auto kEnd = std::ifstream::traits_type::eof();
  if (!is_directory && file && file.peek() == kEnd && !file.bad()) return {};  // to << an empty file is a failure
  std::ostringstream text;
  if (is_directory || !file || !(text << file.rdbuf())) {
    throw TroubleError("cannot read the scene file '{}': {}", path.string(),
                       is_directory ? "it is a directory" : std::strerror(errno));
  }
  return text.str();
}

/// But for old names.
template <typename Key>
std::vector<std::string> Names(std::span<const Key> keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) {
    if constexpr (requires { key.now; }) {
      if (!key.now.empty()) continue;
    }
    names.push_back(key.name);
  }
  return names;
}

/// The keys outside the arrays of tables, the tables that they are in, and the two arrays.
std::vector<std::string> AcceptedPaths() {
  std::vector<std::string> paths = {"wall", "key"};
  for (const SceneKey& key : AllSceneKeys()) {
    paths.push_back(key.name);
    for (auto dot = key.name.find('.'); dot != std::string::npos; dot = key.name.find('.', dot + 1)) {
      paths.push_back(key.name.substr(0, dot));
    }
  }
  return paths;
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
        const Value value(node, path, source_);
        key->apply(scene_, value);
        given_.emplace(path, value.Place());
      } else if (const SceneKey* inside = FirstKeyOf(path + "."); inside == nullptr) {
        throw UsageError("{}: unknown key '{}'.{}", Place(node), path, DidYouMean(path, AcceptedPaths()));
      } else if (!node.is_table()) {
        throw UsageError("{}: {} takes keys of its own, such as {}", Place(node), path, inside->name);
      } else {
        Read(*node.as_table(), path + ".");
      }
    }
  }

  /// UsageError naming the first required key that was not given, or two of which a scene takes one.
  void CheckComplete() const {
    for (const SceneKey& key : AllSceneKeys()) {
      if (key.required && !given_.contains(key.name)) {
        throw UsageError("{}: the key '{}' is missing ({})", source_, key.name, key.what);
      }
    }
    for (const std::string group : {"equation_of_state.", "fluid.region."}) CheckOneOf(group);
  }

  GivenKeys Given() const {
    GivenKeys keys;
    for (const auto& [path, place] : given_) keys.insert(path);
    return keys;
  }

  /// UsageError naming a key that was given and that the scene's solver does not use.
  void CheckUsed() const {
    for (const auto& [path, place] : given_) CheckUsed(path, place);
  }
  /// The same of the keys that are set at the press of a key.
  void CheckControlsUsed() const {
    for (const SceneControl& control : scene_.controls) {
      for (const auto& action : control.actions) {
        const auto* set = std::get_if<SetAction>(&action);
        if (set != nullptr) CheckUsed(set->key, fmt::format("{}: key '{}'", source_, control.press));
      }
    }
  }

 private:
  /// What is no scene key is left to others.
  void CheckUsed(const std::string& path, const std::string& place) const {
    const SceneKey* key = FindSceneKey(path);
    if (key == nullptr || key->UsedBy(scene_.solver)) return;
    throw UsageError("{}: {} is for solver {}, and solver '{}' does not use it", place, path,
                     fmt::join(key->solvers, " or "), scene_.solver);
  }
  /// UsageError if keys of two members of the group were given, as in equation_of_state.tait and
  /// equation_of_state.polytrope.
  void CheckOneOf(const std::string& group) const {
    std::string first;
    for (const auto& [path, place] : given_) {
      if (!path.starts_with(group)) continue;
      const std::string member = path.substr(0, path.find('.', group.size()));
      if (first.empty()) first = member;
      if (member != first) throw UsageError("{}: {} beside {}: a scene takes one of them", place, member, first);
    }
  }

  static const SceneKey* FirstKeyOf(const std::string& prefix) {
    const auto keys = AllSceneKeys();
    const auto starts = [&](const SceneKey& key) { return key.name.starts_with(prefix); };
    const auto found = std::find_if(keys.begin(), keys.end(), starts);
    return found == keys.end() ? nullptr : &*found;
  }

  std::string Place(const toml::node& node) const { return Value(node, "", source_).Place(); }

  /// Calls read(key, value) for the entries of one table of an array of tables, in the order of `keys`.
  template <typename Key, typename Read>
  void ReadEntries(const toml::table& table, const std::string& prefix, std::span<const Key> keys, Read read) const {
    for (const auto& [name, node] : table) {
      if (std::ranges::find(keys, name.str(), &Key::name) == keys.end()) {
        throw UsageError("{}: unknown key '{}.{}'.{}", Place(node), prefix, name.str(),
                         DidYouMean(name.str(), Names(keys)));
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

  /// UsageError if a wall has a key by its old and its new name.
  void CheckOldNames(const toml::table& wall) const {
    for (const WallKey& key : AllWallKeys()) {
      if (key.now.empty() || !wall.contains(key.name) || !wall.contains(key.now)) continue;
      throw UsageError("{}: wall.{} is the old name of wall.{}, which is there, too", Place(*wall.get(key.name)),
                       key.name, key.now);
    }
  }

  void ReadWalls(const toml::node& node) {
    if (const auto* by_name = node.as_table(); by_name != nullptr && source_.starts_with("--")) {
      SetWalls(*by_name);
      return;
    }
    for (const toml::node& element : Tables(node, "wall")) {
      Wall wall;
      CheckOldNames(*element.as_table());
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
        const std::string_view entry_name = entry.str();
        const auto key = std::find_if(keys.begin(), keys.end(), [&](const WallKey& k) { return k.name == entry_name; });
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
  std::map<std::string, std::string, std::less<>> given_;  // keys, and their places
};

/// "a.b=3" as a table. A value that is not TOML is taken as a text, so that names need no quotes.
toml::table ParseSetting(const std::string& setting) {
  const auto equals = setting.find('=');
  const bool one_line = setting.find_first_of("\r\n") == std::string::npos;
  const std::string key = setting.substr(0, equals);
  const auto name = key.find_first_not_of(" \t");
  if (equals == std::string::npos || !one_line || name == std::string::npos || key[name] == '#') {
    throw UsageError("--set {}: it takes KEY=VALUE, such as forces.damping=0.5", setting);
  }
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
  Scene scene = ParseScene(ReadText(path), path.string(), settings);
  scene.name = path.stem().string();
  return scene;
}

Scene ParseScene(const std::string& text, const std::string& source, std::span<const std::string> settings) {
  Scene scene;
  SceneReader reader(scene, source);
  try {
    reader.Read(toml::parse(text, source));
  } catch (const toml::parse_error& error) {
    throw UsageError("{}:{}:{}: {}", source, error.source().begin.line, error.source().begin.column,
                     error.description());
  }
  reader.CheckComplete();
  reader.CheckUsed();
  reader.CheckControlsUsed();
  const std::string own_solver = scene.solver;
  SceneReader setter(scene, "--set");
  for (const std::string& setting : settings) setter.Read(ParseSetting(setting));
  setter.CheckUsed();  // by the solver that may be among them
  GivenKeys given = setter.Given();
  // What a scene says of its own solver's resolution is not said of another's.
  for (const std::string& key : reader.Given()) {
    const bool of_resolution = key == "method.smoothing_length" || key == "method.step" || key == "method.time_step";
    if (scene.solver == own_solver || !of_resolution) given.insert(key);
  }
  CheckFluid(scene, source);
  CompleteMethod(scene, given);
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
  constexpr double kWholeUpTo = 0x1.0p53;
  if (number == std::floor(number) && std::abs(number) <= kWholeUpTo) {  // which goes for a number, too
    const toml::value<std::int64_t> node(static_cast<std::int64_t>(number));
    found->apply(scene, Value(node, key, "--set"));
  } else {
    const toml::value<double> node(number);
    found->apply(scene, Value(node, key, "--set"));
  }
}

}  // namespace sph
