// Draws a session into the window: its system, and the words over it.
#pragma once

#include <string>

#include "io/image.hpp"
#include "render/renderer.hpp"
#include "window/camera.hpp"
#include "window/rate_meter.hpp"
#include "window/session.hpp"
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
  /// Shows this scene whole.
  void Fit(const Scene& scene);

  /// The whole frame, into the framebuffer that is bound.
  void Draw(Session& session, const Rates& rates, const std::string& message);
  /// The picture without words, except for the legend; the framebuffer holds it afterwards.
  Image TakePicture(Session& session);

 private:
  void Begin(Session& session);

  GlFunctions gl_;
  UiScale ui_scale_;
  Renderer renderer_;
  Camera camera_;
};

}  // namespace sph
