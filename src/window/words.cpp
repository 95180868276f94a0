#include "window/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/catalogue.hpp"
#include "window/controls.hpp"

namespace sph {
namespace {

/// The scene's own words for one of `keys`; empty if it has none.
std::string InTheScene(const Scene& scene, const std::vector<std::string>& keys) {
  for (const SceneControl& control : scene.controls) {
    if (std::find(keys.begin(), keys.end(), control.press) != keys.end()) return control.what;
  }
  return {};
}

}  // namespace

std::string StatusLine(const Session& session, const Rates& rates) {
  const ParticleSystemSPH& system = session.System();
  std::string line = fmt::format("{}   N {}   t {:.3f} s   step {}", session.CurrentScene().name, system.State().Size(),
                                 system.Time(), system.Steps());
  if (system.Trouble()) return line + "   stopped";
  if (session.paused) return line + "   paused";
  const std::string pace = rates.pace < 0.1 ? fmt::format("{:.2g}", rates.pace) : fmt::format("{:.2f}", rates.pace);
  return line + fmt::format("   {:.0f} steps/s   {} x real time   {:.0f} fps", rates.steps, pace, rates.frames);
}

std::string StandingMessage(const Session& session) {
  const auto& trouble = session.System().Trouble();
  return trouble ? "unstable: " + trouble->Message() + "\nb goes back to the last good state, r resets the scene"
                 : std::string();
}

std::vector<HelpRow> HelpRows(const Session& session) {
  const Scene& scene = session.CurrentScene();
  std::vector<HelpRow> rows;
  for (const Control& control : AllControls()) {
    const std::string own = InTheScene(scene, control.keys);
    rows.push_back({control.shown, own.empty() ? control.does : own});
  }
  for (const SceneControl& control : scene.controls) {
    if (FindControl(control.press) == nullptr) rows.push_back({control.press, control.what});
  }
  return rows;
}

std::string WindowTitle(const Session& session) { return "sphlab: " + session.CurrentScene().name; }

}  // namespace sph
