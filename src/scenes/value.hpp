// One value from a scene file or from --set, with the place it came from: read as a checked number, name, box, ...
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <span>
#include <string>

#include "base/vec2.hpp"

namespace sph {

/// The numbers that a key accepts: least <= value <= greatest, without the least if it is `open`.
struct Accepted {
  double least;
  double greatest;
  bool open = false;

  bool Holds(double value) const { return value <= greatest && (open ? value > least : value >= least); }
  std::string InWords() const;

  static Accepted Any();
  static Accepted Positive();
  static Accepted NotNegative();
};

/// Every As... throws UsageError, naming the place, the key, what was found and what is accepted.
class Value {
 public:
  Value(const toml::node& node, std::string key, std::string source);

  double AsNumber(const Accepted& accepted) const;
  std::int64_t AsInteger(std::int64_t least, std::int64_t greatest) const;
  std::string AsText() const;
  bool AsFlag() const;
  Vec2 AsVec2() const;
  /// [x0, y0, x1, y1] with x0 < x1, y0 < y1.
  Box AsBox() const;
  /// The position of the text in `names`.
  std::size_t AsChoice(std::span<const std::string> names) const;

  /// A value inside this one, from the same source.
  Value Inner(const toml::node& node, const std::string& key) const { return {node, key_ + "." + key, source_}; }

  const std::string& Key() const { return key_; }
  /// "file:line:column", or "--set".
  std::string Place() const;
  const toml::node& Node() const { return node_; }

 private:
  [[noreturn]] void Refuse(const std::string& accepted) const;
  std::vector<double> AsNumbers(std::size_t count, const std::string& accepted) const;

  const toml::node& node_;
  std::string key_;
  std::string source_;
};

}  // namespace sph
