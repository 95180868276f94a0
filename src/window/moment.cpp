#include "window/moment.hpp"

#include "scenes/build.hpp"
#include "window/words.hpp"

namespace sph {

void Note(Session& session, const Rates& rates, Moment& moment) {
  ParticleSystemSPH& system = session.System();
  const bool shows_field = session.colouring == Colouring::kPressure || session.colouring == Colouring::kDensity;
  // Particles may have come in, or all be new, since the last step.
  if (shows_field && system.Density().size() != system.State().Size()) system.ComputeFields();
  moment.snapshot.Begin(session.colouring);
  system.Draw(moment.snapshot);

  moment.status = StatusLine(session, rates);
  moment.standing = StandingMessage(session);
  moment.window_title = WindowTitle(session);
  moment.scene_name = session.CurrentScene().name;
  moment.scene_title = session.CurrentScene().title;
  moment.help = session.show_help ? HelpRows(session) : std::vector<HelpRow>();
  moment.content = InitialView(session.CurrentScene());
}

}  // namespace sph
