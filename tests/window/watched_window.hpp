// The program with its window on a display that nobody sees, watched by its pixels.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "io/scratch.hpp"
#include "render/view.hpp"
#include "window/hidden_display.hpp"

namespace sph {

/// Asks until the answer is yes, for as long as a slow machine may need. @return the last answer
bool Eventually(const std::function<bool()>& question);

/// The program running by itself, in an empty directory of its own.
class RunningProgram {
 public:
  /// Variables with an empty value are unset.
  RunningProgram(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment);
  /// Ends it if it still runs.
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Its exit code; minus the signal's number if one ended it; a test failure if it does not end.
  int WaitForEnd();
  void Signal(int signal) const;
  /// Processor time used so far [s].
  double ProcessorSeconds() const;
  /// What it has written to stdout and stderr.
  std::string Output() const { return Contents(directory_.Path() / "output"); }
  const std::filesystem::path& Directory() const { return directory_.Path(); }

 private:
  bool HasEnded();

  ScratchDirectory directory_;
  int process_ = -1;
  int status_ = 0;
};

class WatchedWindow {
 public:
  /// `sphlab SCENE ARGUMENTS...`; returns when the window shows something.
  explicit WatchedWindow(const std::string& scene = "dam-break", const std::vector<std::string>& arguments = {});

  RunningProgram& Program() { return program_; }
  HiddenDisplay& Screen() { return display_; }
  HiddenDisplay::WindowId Id() const { return window_; }
  std::string Title() const { return display_.Title(window_); }

  void Press(const std::string& key) const { display_.Type({"key", key}); }
  void HoldDown(const std::string& key) const { display_.Type({"keydown", key}); }
  void LetGo(const std::string& key) const { display_.Type({"keyup", key}); }
  /// Presses a key whose message is another than the one that stands there, and waits until it stands there.
  void PressAndSeeMessage(const std::string& key) const;

  Image Look() const { return display_.Picture(window_); }
  /// Two looks in a row that show the same between status line and message.
  Image LookWhenStill() const;
  /// How the scene lies in a picture of the window.
  View ViewIn(const Image& image) const;
  /// The part of the pixels in this box of the plane [m] that are dark, from 0 to 1.
  double Darkness(const Image& image, const Box& box) const;
  double Darkness(const Box& box) const { return Darkness(Look(), box); }
  /// Where a vertical wall stands that crosses the whole height of the box [m], if one does.
  std::optional<double> FindWall(const Box& box) const;

 private:
  std::string scene_;
  HiddenDisplay display_;
  RunningProgram program_;
  HiddenDisplay::WindowId window_ = 0;
};

/// The number of pixels of a picture for which `is` holds: is(red, green, blue).
int CountPixels(const Image& image, const std::function<bool(int, int, int)>& is);

/// The rows from `top` to the one before `bottom`.
Image Rows(const Image& image, int top, int bottom);

}  // namespace sph
