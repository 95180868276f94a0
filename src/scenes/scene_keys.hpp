// The one table of scene keys: what a scene file or --set may say, what is accepted, and where it goes.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.hpp"
#include "scenes/value.hpp"

namespace sph {

/// Whether a key may be set while the scene runs.
enum class When { kAtStart, kAnyTime };

struct SceneKey {
  std::string name;  ///< dotted, as --set takes it
  std::string what;  ///< meaning and unit
  When when = When::kAtStart;
  bool required = false;
  std::function<void(Scene&, const Value&)> apply;
  std::vector<std::string> solvers = {};  ///< that use it; empty: all do

  bool UsedBy(const std::string& solver) const;
};

/// Every key outside the two arrays of tables, in the order of the documentation.
std::span<const SceneKey> AllSceneKeys();
const SceneKey* FindSceneKey(std::string_view name);

/// The keys of one [[wall]], of one [[key]], and of one entry of a key's `do`.
struct WallKey {
  std::string name;
  std::string what;
  bool required = false;
  std::function<void(Scene&, Wall&, const Value&)> apply;
  std::string now = {};  ///< the key that took the place of this one, which is read for a while
};
std::span<const WallKey> AllWallKeys();

struct ControlKey {
  std::string name;
  std::string what;
  bool required = false;
  std::function<void(SceneControl&, const Value&)> apply;
};
std::span<const ControlKey> AllControlKeys();

}  // namespace sph
