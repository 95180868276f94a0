#include "window/camera.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

// What the text takes of the window [pixels at UI scale 1].
constexpr double kMargin = 6;
constexpr double kStatusWidth = 620;
constexpr double kStatusHeight = 38;
constexpr double kLegendWidth = 220;
constexpr double kLegendHeight = 74;
constexpr double kMessageHeight = 38;

/// `content` as large and central as can be between `top` and `bottom` pixels from the window's edges.
View Between(const Box& content, PixelSize window, double ui_scale, double top, double bottom) {
  const double height = window.height;
  const double shrink = std::min(1.0, 0.5 * height / (top + bottom));  // a tiny window still shows more than text
  const double margin = std::min(kMargin * ui_scale, 0.25 * window.width);
  const double free_width = window.width - 2 * margin;
  const double free_height = height - shrink * (top + bottom);
  const double scale = std::min(free_width / content.Width(), free_height / content.Height());  // [pixels/m]
  const Vec2 middle = content.Centre();
  const double below = (shrink * bottom + 0.5 * free_height) / scale;
  const double half_width = 0.5 * window.width / scale;
  return {{middle.x - half_width, middle.y - below, middle.x + half_width, middle.y - below + height / scale},
          window.width,
          window.height};
}

bool ClearOfText(const View& view, const Box& content, double ui_scale) {
  const Vec2 top_left = view.ToPixel({content.x0, content.y1});
  const Vec2 top_right = view.ToPixel({content.x1, content.y1});
  const bool below_status = top_left.y >= kStatusHeight * ui_scale || top_left.x >= kStatusWidth * ui_scale;
  const bool below_legend =
      top_right.y >= kLegendHeight * ui_scale || top_right.x <= view.width - kLegendWidth * ui_scale;
  return below_status && below_legend;
}

}  // namespace

void Camera::Fit(const Box& content) {
  content_ = content;
  Update();
}

void Camera::Resize(PixelSize window, double ui_scale) {
  view_.width = std::max(1, window.width);
  view_.height = std::max(1, window.height);
  ui_scale_ = ui_scale;
  Update();
}

void Camera::Update() {
  const PixelSize window{view_.width, view_.height};
  for (const double top : {kMargin, kStatusHeight, kLegendHeight}) {
    view_ = Between(content_, window, ui_scale_, top * ui_scale_, kMessageHeight * ui_scale_);
    if (ClearOfText(view_, content_, ui_scale_)) return;
  }
}

PixelSize FirstWindowSize(const Box& content, PixelSize screen, double ui_scale) {
  constexpr double kOfScreen = 0.85;
  const double text_height = (kLegendHeight + kMessageHeight) * ui_scale;
  const double widest = kOfScreen * screen.width;
  const double highest = kOfScreen * screen.height;
  const double scale = std::min((widest - 2 * kMargin * ui_scale) / content.Width(),
                                std::max(0.5 * highest, highest - text_height) / content.Height());
  const double width =
      std::max(scale * content.Width() + 2 * kMargin * ui_scale, std::min(kStatusWidth * ui_scale, widest));
  return {static_cast<int>(std::lround(width)), static_cast<int>(std::lround(scale * content.Height() + text_height))};
}

}  // namespace sph
