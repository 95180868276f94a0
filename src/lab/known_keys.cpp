#include "lab/known_keys.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "base/error.hpp"
#include "scenes/scene_keys.hpp"

namespace sph {
namespace {

/// The names that a key takes, from its refusal of one that is none; empty if it takes no names.
std::vector<std::string> FindChoices(const SceneKey& key) {
  Scene scene;
  const toml::value<std::string> node("-");
  try {
    key.apply(scene, Value(node, key.name, "--set"));
  } catch (const UsageError& error) {
    const std::string message = error.what();
    const std::string head = "one of: ";
    const auto begin = message.find(head);
    if (begin == std::string::npos) return {};
    std::vector<std::string> names;
    std::string list = message.substr(begin + head.size());
    list.resize(std::min(list.find('.'), list.size()));
    for (std::size_t at = 0; at < list.size();) {
      const auto comma = std::min(list.find(", ", at), list.size());
      names.push_back(list.substr(at, comma - at));
      at = comma + 2;
    }
    return names;
  }
  return {};
}

bool Takes(const SceneKey& key, const toml::node& node) {
  Scene scene;
  try {
    key.apply(scene, Value(node, key.name, "--set"));
    return true;
  } catch (const Error&) {
    return false;
  }
}

KeyKind KindOf(const SceneKey& key) {
  if (Takes(key, toml::array{0.0, 0.0, 1.0, 1.0})) return KeyKind::kBox;
  if (Takes(key, toml::array{0.5, 0.5})) return KeyKind::kVec2;
  if (Takes(key, toml::value<double>(0.5)) || Takes(key, toml::value<double>(1.5))) return KeyKind::kNumber;
  if (Takes(key, toml::value<std::int64_t>(1))) return KeyKind::kWhole;
  return KeyKind::kText;
}

}  // namespace

const std::vector<KnownKey>& KnownKeys() {
  static const std::vector<KnownKey> keys = [] {
    std::vector<KnownKey> all;
    for (const SceneKey& key : AllSceneKeys()) {
      all.push_back({key.name, KindOf(key), FindChoices(key), key.required, Takes(key, toml::value<double>(-0.5)),
                     Takes(key, toml::value<double>(1.5))});
    }
    return all;
  }();
  return keys;
}

const std::vector<std::string>& ChoicesOf(std::string_view key) {
  const auto known = std::ranges::find(KnownKeys(), key, &KnownKey::name);
  SPH_CHECK(known != KnownKeys().end(), "key '{}'", key);
  return known->choices;
}

}  // namespace sph
