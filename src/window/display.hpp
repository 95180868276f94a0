// The X display that a window goes to: asked before freeglut, which would end the program if there is none.
#pragma once

#include <optional>
#include <string>

#include "base/library.hpp"

namespace sph {

/// A connection of our own to $DISPLAY. To be kept until freeglut has its own: a server whose last client leaves may
/// start anew (Xvfb does), and turn away who comes just then. From then on a server that goes away, on whatever
/// connection, ends the program with ExitCode::kTrouble and a line that names it.
class Display {
 public:
  /// TroubleError if there is no display, with what was tried and with `advice`: what to do without one.
  explicit Display(const std::string& advice);
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// The X resource Xft.dpi, where a desktop says how large letters are to be; none if it does not.
  std::optional<double> DotsPerInch() const;
  /// The window that gets the keys, or what the server says instead.
  unsigned long Focus() const;

  /// Has a key that is held be reported as pressed again and again, not as released and pressed again and again, to
  /// whom `connection` (an Xlib one) belongs. @return whether the server can do that
  bool ReportRepeatsAsPresses(void* connection) const;

  /// Events that `connection` (an Xlib one) has already read, or can read now: they are to be dealt with before its
  /// descriptor is waited on.
  bool HasEvents(void* connection) const;
  /// Can be read when the server has sent something to `connection`.
  int Descriptor(void* connection) const;

  /// While one of these lives, a crash ends the program as a lost server does. Mesa (22.3) crashes where a server dies
  /// before it has answered which GLX it has.
  class Opening {
   public:
    Opening();
    ~Opening();
    Opening(const Opening&) = delete;
    Opening& operator=(const Opening&) = delete;

   private:
    void (*handler_before_)(int);
  };

  /// While one of these lives, a request that the server refuses fails without ending the program, as Xlib would have
  /// it.
  class Forgiving {
   public:
    explicit Forgiving(const Display& display);
    ~Forgiving();
    Forgiving(const Forgiving&) = delete;
    Forgiving& operator=(const Forgiving&) = delete;

   private:
    const Display& display_;
    void* handler_before_;
  };

 private:
  Library xlib_;
  void* connection_ = nullptr;
};

}  // namespace sph
