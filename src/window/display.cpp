#include "window/display.hpp"

#include <unistd.h>

#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "base/error.hpp"

namespace sph {
namespace {

const std::array<std::string, 1> kXlib = {"libX11.so.6"};

// The part of Xlib's interface that is used here, stated by us.
using OpenDisplay = void* (*)(const char* name);
using CloseDisplay = int (*)(void* connection);
using GetDefault = char* (*)(void* connection, const char* program, const char* option);
using GetInputFocus = int (*)(void* connection, unsigned long* window, int* where_it_goes_back_to);
using SetDetectableAutoRepeat = int (*)(void* connection, int detectable, int* supported);
using Pending = int (*)(void* connection);
using ConnectionNumber = int (*)(void* connection);
using ErrorHandler = int (*)(void* connection, void* error);
using SetErrorHandler = ErrorHandler (*)(ErrorHandler);
using IOErrorHandler = int (*)(void* connection);
using SetIOErrorHandler = IOErrorHandler (*)(IOErrorHandler);

int Ignore(void*, void*) { return 0; }

/// "" if it is not set.
std::string DisplayName() {
  const char* name = std::getenv("DISPLAY");
  return name == nullptr ? "" : name;
}

/// What is said when the server is gone; made beforehand, as a signal's handler may not.
std::string& Farewell() {
  static std::string text;
  return text;
}

/// Without what is to be done at a program's end: that crashes where other threads still run.
[[noreturn]] void EndAtOnce() {
  const std::string& text = Farewell();
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
  _exit(static_cast<int>(ExitCode::kTrouble));
}
int OnLostServer(void*) { EndAtOnce(); }
void OnCrash(int) { EndAtOnce(); }

Library LoadXlib(const std::string& advice) {
  if (DisplayName().empty()) throw TroubleError("no display to open a window on: DISPLAY is not set.\n{}", advice);
  return Library("X11, which brings the display", kXlib, "libx11-6");
}

}  // namespace

Display::Display(const std::string& advice) : xlib_(LoadXlib(advice)) {
  connection_ = xlib_.Find<OpenDisplay>("XOpenDisplay")(nullptr);
  if (connection_ == nullptr) {
    throw TroubleError("no display to open a window on: the X server of DISPLAY={} does not answer, or refuses.\n{}",
                       DisplayName(), advice);
  }
  Farewell() = "sphlab: lost the X server of DISPLAY=" + DisplayName() + "\n";
  std::signal(SIGPIPE, SIG_IGN);  // Xlib is to see that nobody reads any more
  xlib_.Find<SetIOErrorHandler>("XSetIOErrorHandler")(&OnLostServer);
}

Display::~Display() { xlib_.Find<CloseDisplay>("XCloseDisplay")(connection_); }

std::optional<double> Display::DotsPerInch() const {
  const char* text = xlib_.Find<GetDefault>("XGetDefault")(connection_, "Xft", "dpi");
  double value = 0;
  if (text == nullptr) return std::nullopt;
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), value);
  if (error != std::errc() || *end != '\0' || !(value > 0)) return std::nullopt;
  return value;
}

unsigned long Display::Focus() const {
  unsigned long window = 0;
  int where_it_goes_back_to = 0;
  xlib_.Find<GetInputFocus>("XGetInputFocus")(connection_, &window, &where_it_goes_back_to);
  return window;
}

bool Display::ReportRepeatsAsPresses(void* connection) const {
  int supported = 0;
  xlib_.Find<SetDetectableAutoRepeat>("XkbSetDetectableAutoRepeat")(connection, 1, &supported);
  return supported != 0;
}

bool Display::HasEvents(void* connection) const { return xlib_.Find<Pending>("XPending")(connection) > 0; }
int Display::Descriptor(void* connection) const {
  return xlib_.Find<ConnectionNumber>("XConnectionNumber")(connection);
}

Display::Forgiving::Forgiving(const Display& display)
    : display_(display),
      handler_before_(reinterpret_cast<void*>(display.xlib_.Find<SetErrorHandler>("XSetErrorHandler")(&Ignore))) {}

Display::Forgiving::~Forgiving() {
  display_.xlib_.Find<SetErrorHandler>("XSetErrorHandler")(reinterpret_cast<ErrorHandler>(handler_before_));
}

Display::Opening::Opening() : handler_before_(std::signal(SIGSEGV, &OnCrash)) {}

Display::Opening::~Opening() { std::signal(SIGSEGV, handler_before_); }

}  // namespace sph
