// An X display that nobody sees (Xvfb): windows found, looked at, resized and closed in it, keys typed on its keyboard.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/image.hpp"

namespace sph {

class HiddenDisplay {
 public:
  using WindowId = unsigned long;

  /// Starts Xvfb on a display number that is free. A test failure if it does not answer.
  explicit HiddenDisplay(const std::vector<std::string>& xvfb_options = {});
  /// Ends it.
  ~HiddenDisplay();
  HiddenDisplay(const HiddenDisplay&) = delete;
  HiddenDisplay& operator=(const HiddenDisplay&) = delete;

  /// As DISPLAY takes it, such as ":3".
  const std::string& Name() const;

  /// The window that can be seen, if there is one; tests open one at a time.
  std::optional<WindowId> FindWindow() const;
  std::string Title(WindowId window) const;
  /// What it shows; an empty picture if it is gone, or reaches beyond the screen.
  Image Picture(WindowId window) const;
  void Resize(WindowId window, int width, int height);
  /// As the button of a window manager does it (WM_DELETE_WINDOW).
  void AskToClose(WindowId window);
  /// Puts it into the corner of the screen, whole, where Picture can see it, and has the keys go to it.
  void BringForward(WindowId window);
  /// xdotool with these words: "key", "keydown" or "keyup" and names of keys.
  void Type(std::vector<std::string> words) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sph
