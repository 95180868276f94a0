#include "window/screen.hpp"

#include "scenes/build.hpp"
#include "window/words.hpp"

namespace sph {

Screen::Screen(const GlLoader& loader, const UiScale& ui_scale)
    : gl_(LoadGlFunctions(loader)), ui_scale_(ui_scale), renderer_(gl_) {}

void Screen::Resize(PixelSize window) {
  const double scale = ui_scale_.For(window.width, window.height);
  renderer_.SetUiScale(scale);
  camera_.Resize(window, scale);
}

void Screen::Fit(const Scene& scene) { camera_.Fit(InitialView(scene)); }

/// Begins a frame, and has the system drawn.
void Screen::Begin(Session& session) {
  ParticleSystemSPH& system = session.System();
  const bool shows_field = session.colouring == Colouring::kPressure || session.colouring == Colouring::kDensity;
  // Particles may have come in, or all be new, since the last step.
  if (shows_field && system.Density().size() != system.State().Size()) system.ComputeFields();
  renderer_.BeginFrame(camera_.CurrentView(), session.colouring);
  system.Draw(renderer_);
}

void Screen::Draw(Session& session, const Rates& rates, const std::string& message) {
  Begin(session);
  TextLayer& text = renderer_.Text();
  text.StatusLine(StatusLine(session, rates));
  const std::string standing = StandingMessage(session);
  text.Message(standing.empty() ? message : standing);
  if (session.show_help) text.HelpTable(session.CurrentScene().title, HelpRows(session));
  renderer_.EndFrame();
}

Image Screen::TakePicture(Session& session) {
  Begin(session);
  renderer_.EndFrame();
  return renderer_.ReadImage();
}

}  // namespace sph
