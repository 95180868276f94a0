// What part of the plane the window shows: the scene whole, clear of the places that text needs.
#pragma once

#include "base/vec2.hpp"
#include "render/view.hpp"

namespace sph {

struct PixelSize {
  int width = 0;
  int height = 0;
};

class Camera {
 public:
  /// Shows `content` [m], not empty, whole: beside or below status line and legend, and above the message line.
  void Fit(const Box& content);
  /// The window's size [pixels], and the scale of the text in it.
  void Resize(PixelSize window, double ui_scale);

  const View& CurrentView() const { return view_; }

 private:
  void Update();

  Box content_{0, 0, 1, 1};
  double ui_scale_ = 1;
  View view_{content_, 1, 1};
};

/// A window that shows `content` as large as fits well on the screen.
PixelSize FirstWindowSize(const Box& content, PixelSize screen, double ui_scale);

}  // namespace sph
