#include "render/view.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace sph {

double View::Scale() const {
  SPH_CHECK(region.Width() > 0 && region.Height() > 0, "region {} m x {} m", region.Width(), region.Height());
  SPH_CHECK(width > 0 && height > 0, "window {} x {} pixels", width, height);
  return std::min(width / region.Width(), height / region.Height());
}

Box View::Visible() const {
  const Vec2 half = (0.5 / Scale()) * Vec2{static_cast<double>(width), static_cast<double>(height)};
  const Vec2 low = region.Centre() - half;
  const Vec2 high = region.Centre() + half;
  return {low.x, low.y, high.x, high.y};
}

Vec2 View::ToPixel(Vec2 point) const {
  const Vec2 offset = Scale() * (point - region.Centre());
  return {0.5 * width + offset.x, 0.5 * height - offset.y};
}

Vec2 View::ToPlane(Vec2 pixel) const {
  return region.Centre() + (1 / Scale()) * Vec2{pixel.x - 0.5 * width, 0.5 * height - pixel.y};
}

View View::ZoomedAbout(Vec2 pixel, double factor) const {
  SPH_CHECK(factor > 0, "factor {}", factor);
  const Vec2 fixed = ToPlane(pixel);
  const auto towards = [factor](double from, double to) { return from + (to - from) / factor; };
  return {{towards(fixed.x, region.x0), towards(fixed.y, region.y0), towards(fixed.x, region.x1),
           towards(fixed.y, region.y1)},
          width,
          height};
}

View View::Panned(Vec2 pixels) const {
  const Vec2 moved = (1 / Scale()) * Vec2{-pixels.x, pixels.y};
  return {{region.x0 + moved.x, region.y0 + moved.y, region.x1 + moved.x, region.y1 + moved.y}, width, height};
}

View ViewOf(const Box& content, int width, int height, double margin, double top) {
  const double shrink = std::min({1.0, 0.5 * width / (2 * margin), 0.5 * height / (margin + top)});
  const double side = shrink * margin;  // [pixels]
  const double above = shrink * top;
  const double scale = std::min((width - 2 * side) / content.Width(), (height - side - above) / content.Height());
  return {{content.x0 - side / scale, content.y0 - side / scale, content.x1 + side / scale, content.y1 + above / scale},
          width,
          height};
}

}  // namespace sph
