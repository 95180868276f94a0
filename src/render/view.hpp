// What part of the plane is seen in how many pixels.
#pragma once

#include "base/vec2.hpp"

namespace sph {

/// `region` [m] is shown whole and centred in a window of width x height pixels, with the same scale in x and y; where
/// the shapes differ, more of the plane is seen on two sides. Pixel coordinates count from the top left corner, y
/// downwards; the centre of the first pixel is at (0.5, 0.5). Precondition: region and window are not empty.
struct View {
  Box region;
  int width = 0;   // [pixels]
  int height = 0;  // [pixels]

  /// Pixels per metre.
  double Scale() const;
  /// All that the window shows [m]: contains `region` and has the window's shape.
  Box Visible() const;
  /// From the plane [m] to pixels, and back.
  Vec2 ToPixel(Vec2 point) const;
  Vec2 ToPlane(Vec2 pixel) const;
  /// The view at `factor` > 0 times the scale in which `pixel` shows the same point of the plane as before.
  View ZoomedAbout(Vec2 pixel, double factor) const;
  /// The view with everything moved by `pixels`.
  View Panned(Vec2 pixels) const;
};

/// The view of `content` [m] with a margin of `margin` pixels on each side but the top, where it is `top` (all less in
/// a window too small for them: half of it at least is for the content).
View ViewOf(const Box& content, int width, int height, double margin, double top);

}  // namespace sph
