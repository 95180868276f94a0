#include "window/screen.hpp"

namespace sph {

Screen::Screen(const GlLoader& loader, const UiScale& ui_scale)
    : gl_(LoadGlFunctions(loader)), ui_scale_(ui_scale), renderer_(gl_) {}

void Screen::Resize(PixelSize window) {
  const double scale = ui_scale_.For(window.width, window.height);
  renderer_.SetUiScale(scale);
  camera_.Resize(window, scale);
}

/// Begins a frame, and draws what the system has drawn.
void Screen::Begin(const Moment& moment) {
  renderer_.BeginFrame(camera_.CurrentView(), moment.snapshot.WantedColouring());
  moment.snapshot.DrawOn(renderer_);
}

void Screen::Draw(const Moment& moment, const std::string& message) {
  Begin(moment);
  TextLayer& text = renderer_.Text();
  text.StatusLine(moment.status);
  text.Message(moment.standing.empty() ? message : moment.standing);
  if (!moment.help.empty()) text.HelpTable(moment.scene_title, moment.help);
  renderer_.EndFrame();
  gl_.Finish();
}

Image Screen::TakePicture(const Moment& moment) {
  Begin(moment);
  renderer_.EndFrame();
  return renderer_.ReadImage();
}

}  // namespace sph
