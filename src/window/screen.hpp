// Draws a moment of a session into the window: its system, and the words over it.
#pragma once

#include <string>

#include "io/image.hpp"
#include "render/renderer.hpp"
#include "window/camera.hpp"
#include "window/moment.hpp"
#include "window/ui_scale.hpp"

namespace sph {

class Screen {
 public:
  /// The window's context must be current here, in every method and in the destructor. TroubleError if it is not one of
  /// OpenGL 3.3 core.
  Screen(const GlLoader& loader, const UiScale& ui_scale);
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void Resize(PixelSize window);
  /// Shows this part of the plane [m] whole.
  void Fit(const Box& content) { camera_.Fit(content); }

  /// The whole frame, into the framebuffer that is bound; returns when it is drawn.
  void Draw(const Moment& moment, const std::string& message);
  /// The picture without words, except for the legend; the framebuffer holds it afterwards.
  Image TakePicture(const Moment& moment);

 private:
  void Begin(const Moment& moment);

  GlFunctions gl_;
  UiScale ui_scale_;
  Renderer renderer_;
  Camera camera_;
};

}  // namespace sph
