#include "window/hidden_display.hpp"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

// Last, as it makes macros of common words.
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace sph {

struct HiddenDisplay::State {
  pid_t server = -1;
  std::string name;
  ::Display* connection = nullptr;
};

namespace {

/// As exec takes them; valid as long as `words` is.
std::vector<char*> Pointers(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Starts Xvfb, which writes the number of the display that it has found to a pipe.
pid_t StartServer(const std::vector<std::string>& options, std::string& name) {
  int ends[2] = {};
  if (pipe(ends) != 0) return -1;
  const std::string descriptor = std::to_string(ends[1]);
  std::vector<std::string> words = {"Xvfb",         "-displayfd", descriptor, "-screen", "0",
                                    "1280x1024x24", "-nolisten",  "tcp",      "-noreset"};
  words.insert(words.end(), options.begin(), options.end());
  const std::vector<char*> arguments = Pointers(words);
  const pid_t parent = getpid();
  const pid_t server = fork();
  if (server == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // it does not outlive the test, however that ends
    if (getppid() != parent) _exit(1);
    if (freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  close(ends[1]);
  name = ":";
  for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';) name += digit;
  close(ends[0]);
  return server;
}

}  // namespace

HiddenDisplay::HiddenDisplay(const std::vector<std::string>& xvfb_options) : state_(std::make_unique<State>()) {
  state_->server = StartServer(xvfb_options, state_->name);
  XSetErrorHandler([](::Display*, XErrorEvent*) { return 0; });  // a window that is gone is no reason to end the test
  state_->connection = XOpenDisplay(state_->name.c_str());
  if (state_->connection == nullptr) ADD_FAILURE() << "Xvfb does not answer on display " << state_->name;
}

HiddenDisplay::~HiddenDisplay() {
  if (state_->connection != nullptr) XCloseDisplay(state_->connection);
  if (state_->server > 0) {
    kill(state_->server, SIGTERM);
    waitpid(state_->server, nullptr, 0);
  }
}

const std::string& HiddenDisplay::Name() const { return state_->name; }

std::optional<HiddenDisplay::WindowId> HiddenDisplay::FindWindow() const {
  ::Window root = 0;
  ::Window parent = 0;
  ::Window* windows = nullptr;
  unsigned count = 0;
  if (XQueryTree(state_->connection, DefaultRootWindow(state_->connection), &root, &parent, &windows, &count) == 0)
    return {};
  std::optional<WindowId> found;
  for (unsigned i = 0; i < count; ++i) {
    XWindowAttributes attributes;
    if (XGetWindowAttributes(state_->connection, windows[i], &attributes) != 0 && attributes.map_state == IsViewable) {
      found = windows[i];
    }
  }
  if (windows != nullptr) XFree(windows);
  return found;
}

std::string HiddenDisplay::Title(WindowId window) const {
  char* name = nullptr;
  if (XFetchName(state_->connection, window, &name) == 0 || name == nullptr) return {};
  std::string title = name;
  XFree(name);
  return title;
}

Image HiddenDisplay::Picture(WindowId window) const {
  XWindowAttributes attributes;
  if (XGetWindowAttributes(state_->connection, window, &attributes) == 0) return {};
  XImage* seen = XGetImage(state_->connection, window, 0, 0, static_cast<unsigned>(attributes.width),
                           static_cast<unsigned>(attributes.height), AllPlanes, ZPixmap);
  if (seen == nullptr) return {};
  Image image{attributes.width, attributes.height, {}};
  image.rgb.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const unsigned long pixel = XGetPixel(seen, x, y);
      for (const int shift : {16, 8, 0}) image.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  XDestroyImage(seen);
  return image;
}

void HiddenDisplay::Resize(WindowId window, int width, int height) {
  XResizeWindow(state_->connection, window, static_cast<unsigned>(width), static_cast<unsigned>(height));
  XSync(state_->connection, False);
}

void HiddenDisplay::AskToClose(WindowId window) {
  XEvent event = {};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(state_->connection, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(state_->connection, "WM_DELETE_WINDOW", False));
  XSendEvent(state_->connection, window, False, NoEventMask, &event);
  XSync(state_->connection, False);
}

void HiddenDisplay::BringForward(WindowId window) {
  XMoveWindow(state_->connection, window, 0, 0);
  XSetInputFocus(state_->connection, window, RevertToPointerRoot, CurrentTime);
  XSync(state_->connection, False);
}

void HiddenDisplay::Type(std::vector<std::string> words) const {
  words.insert(words.begin(), "xdotool");
  const std::vector<char*> arguments = Pointers(words);
  const pid_t typist = fork();
  if (typist == 0) {
    setenv("DISPLAY", state_->name.c_str(), 1);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = -1;
  waitpid(typist, &status, 0);
  EXPECT_EQ(status, 0) << testing::PrintToString(words);
}

}  // namespace sph
