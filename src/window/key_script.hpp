// --keys "T:KEY,T:KEY": keys pressed at simulated times, through the table of controls.
#pragma once

#include <string>
#include <vector>

#include "window/session.hpp"

namespace sph {

class KeyScript {
 public:
  KeyScript() = default;
  /// "T:KEY" presses KEY at time T [s] and lets it go a tenth of a second later, "T:KEY:SECONDS" after that time;
  /// entries are separated by commas; an empty text has none. `scene` may give keys a meaning of its own. UsageError
  /// with the entry, what is accepted and the nearest key.
  KeyScript(const std::string& text, const Scene& scene);

  /// Presses and releases what is due at the session's time. To be called before each step.
  void Play(Session& session);
  /// The time of the last event played. Read into a script, even into another one, what it has until then counts as
  /// played.
  void Transfer(Archive& archive);
  /// Time of the last event; 0 without events [s].
  double End() const { return events_.empty() ? 0 : events_.back().time; }

 private:
  bool IsDue(double time) const;

  struct Event {
    double time = 0;
    std::string key;
    bool down = true;
  };
  std::vector<Event> events_;  // by time
  std::size_t next_ = 0;
  double played_until_ = -1;  // [s]; below 0 before the first event
};

}  // namespace sph
