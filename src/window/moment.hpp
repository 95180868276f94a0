// What the window shows of a session at one moment: all that drawing needs, so that the session can go on meanwhile.
#pragma once

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "render/snapshot.hpp"
#include "render/text.hpp"
#include "window/rate_meter.hpp"
#include "window/session.hpp"

namespace sph {

struct Moment {
  Snapshot snapshot;          ///< what the system draws
  std::string status;         ///< see StatusLine
  std::string standing;       ///< see StandingMessage
  std::string window_title;   ///< see WindowTitle
  std::string scene_name;     ///< of files
  std::string scene_title;    ///< of the help
  std::vector<HelpRow> help;  ///< empty when it is not to be seen
  Box content;                ///< what shows the scene whole [m]

  // Counted, since a moment may be passed over: who looks acts when the number is another than before.
  long number = 0;        ///< of this moment
  long scene_number = 0;  ///< of the scenes loaded so far
  long presses = 0;       ///< of keys so far; the last had this to say, and what was said before is over
  std::string message;
  long saves = 0;  ///< pictures asked for so far
  bool quit = false;
};

/// Notes what is to be seen of the session now, into a moment whose memory is used again; not what is counted.
void Note(Session& session, const Rates& rates, Moment& moment);

}  // namespace sph
