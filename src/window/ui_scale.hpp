// How large text and lines are drawn: what the user says, else what the desktop says, and more in a large window.
#pragma once

#include <optional>

namespace sph {

class UiScale {
 public:
  /// $SPHLAB_UI_SCALE, a number from 0.5 to 8 (UsageError otherwise), goes before everything else.
  /// @param dots_per_inch  what the desktop asks for, if it does; 96 is scale 1
  explicit UiScale(std::optional<double> dots_per_inch);

  /// Of a window of that many pixels; 1 is text of 15 pixels. In quarters, so that few fonts are made as a window is
  /// resized.
  double For(int width, int height) const;

 private:
  std::optional<double> asked_;
  double desktop_ = 1;
};

}  // namespace sph
