// What is known of the keys of scene files without looking into their table: what they take, found by trying.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sph {

enum class KeyKind { kNumber, kWhole, kText, kVec2, kBox };

struct KnownKey {
  std::string name;
  KeyKind kind = KeyKind::kText;
  std::vector<std::string> choices = {};  ///< names that it takes; empty: it takes no names
  bool required = false;
  bool negative = false;  ///< takes negative numbers
  bool large = false;     ///< takes numbers above 1
};

/// Every key of the table, in its order.
const std::vector<KnownKey>& KnownKeys();

/// The names that a key takes, in the order of its message.
const std::vector<std::string>& ChoicesOf(std::string_view key);

}  // namespace sph
