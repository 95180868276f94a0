// The one table of controls: which key does what. The window, the help screen, --keys and the README's table use it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "window/session.hpp"

namespace sph {

struct Control {
  std::vector<std::string> keys;  ///< any of them; names as in --keys: "d", "Left", "space", ...
  std::string shown;              ///< the keys as people read them
  std::string does;
  void (*press)(Session&, const std::string& key);
  void (*release)(Session&, const std::string& key) = nullptr;
};

std::span<const Control> AllControls();

/// The control of that key, or nullptr.
const Control* FindControl(const std::string& key);
/// Every key name, in the order of the table.
std::vector<std::string> AllKeyNames();

/// What the key does, done; an unknown key leaves a message.
void PressKey(Session& session, const std::string& key);
void ReleaseKey(Session& session, const std::string& key);

}  // namespace sph
