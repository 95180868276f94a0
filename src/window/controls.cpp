#include "window/controls.hpp"

#include <algorithm>

namespace sph {

std::span<const Control> AllControls() {
  using S = Session;
  using Key = const std::string&;
  static const std::vector<Control> controls = {
      {{"d"}, "d", "break the dam, in scenes that have one", [](S& s, Key key) { s.PressSceneKey(key); }},
      {{"Left"},
       "Left",
       "move the wall to the left while held",
       [](S& s, Key) { s.MoveWall(-1); },
       [](S& s, Key) { s.MoveWall(0); }},
      {{"Right"},
       "Right",
       "move the wall to the right while held",
       [](S& s, Key) { s.MoveWall(1); },
       [](S& s, Key) { s.MoveWall(0); }},
      {{"space"}, "space", "drop a block of fluid", [](S& s, Key) { s.DropBlock(); }},
      {{"r"}, "r", "reset", [](S& s, Key) { s.Reset(); }},
      {{"b"}, "b", "back to the last good state", [](S& s, Key) { s.GoBack(); }},
      {{"p"},
       "p",
       "pause, go on",
       [](S& s, Key) {
         s.paused = !s.paused;
         s.message = s.paused ? "paused; . makes one step" : "";
       }},
      {{"."},
       ".",
       "one step",
       [](S& s, Key) {
         s.paused = true;
         ++s.single_steps;
       }},
      {{"["}, "[", "previous scene", [](S& s, Key) { s.GoToNextScene(-1); }},
      {{"]"}, "]", "next scene", [](S& s, Key) { s.GoToNextScene(1); }},
      {{"1", "2", "3", "4", "5", "6", "7", "8", "9"},
       "1 ... 9",
       "scene by number",
       [](S& s, Key key) { s.GoToScene(key[0] - '0'); }},
      {{"c"}, "c", "next colouring: black disks, speed, pressure, density", [](S& s, Key) { s.NextColouring(); }},
      {{"-"}, "-", "slower", [](S& s, Key) { s.ChangeSpeed(0.5); }},
      {{"+", "="}, "+", "faster", [](S& s, Key) { s.ChangeSpeed(2); }},
      {{"s"}, "s", "save a PNG", [](S& s, Key) { s.save_requested = true; }},
      {{"h", "F1"}, "h, F1", "show, hide this help", [](S& s, Key) { s.show_help = !s.show_help; }},
      {{"q", "Esc"}, "q, Esc", "quit", [](S& s, Key) { s.quit_requested = true; }},
  };
  return controls;
}

const Control* FindControl(const std::string& key) {
  for (const Control& control : AllControls()) {
    if (std::find(control.keys.begin(), control.keys.end(), key) != control.keys.end()) return &control;
  }
  return nullptr;
}

std::vector<std::string> AllKeyNames() {
  std::vector<std::string> names;
  for (const Control& control : AllControls()) names.insert(names.end(), control.keys.begin(), control.keys.end());
  return names;
}

void PressKey(Session& session, const std::string& key) {
  if (const Control* control = FindControl(key)) {
    control->press(session, key);
  } else {
    session.PressSceneKey(key);  // a scene may give any other key a meaning of its own
  }
}

void ReleaseKey(Session& session, const std::string& key) {
  const Control* control = FindControl(key);
  if (control != nullptr && control->release != nullptr) control->release(session, key);
}

}  // namespace sph
