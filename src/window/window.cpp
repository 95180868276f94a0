#include "window/window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "base/clock.hpp"
#include "base/library.hpp"
#include "base/memory.hpp"
#include "io/png.hpp"
#include "window/bell.hpp"
#include "window/controls.hpp"
#include "window/display.hpp"
#include "window/glut_library.hpp"
#include "window/key_names.hpp"
#include "window/message_board.hpp"
#include "window/picture_name.hpp"
#include "window/screen.hpp"
#include "window/simulation.hpp"

namespace sph {
namespace {

constexpr double kFrame = 1.0 / 60;  // [s]

/// freeglut calls this instead of ending the program; it passes the exception on, as its frames have unwind tables.
void RefuseGlutError(const char* format, va_list arguments) {
  std::array<char, 1000> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw TroubleError("the window does not open: {}\nsphlab needs an X display with GLX and OpenGL 3.3 core.",
                     text.data());
}

/// Draws what the simulation, in its own thread, was last, and hands keys over to it. freeglut owns window and context;
/// what must be deleted while the context is current is in `screen_`.
class Window {
 public:
  Window(const SceneRequest& request, std::function<bool()> interrupted)
      : simulation_(request, [this] { bell_.Ring(); }),
        interrupted_(std::move(interrupted)),
        display_(
            fmt::format("Without one, `sphlab render {} --out frames` draws the scene to PNG files.", request.scene)),
        ui_scale_(display_.DotsPerInch()),
        glut_(LoadGlut()) {}

  ExitCode Run() {
    Open();
    ListenToKeys();
    simulation_.Start();
    while (screen_) {
      glut_.MainLoopEvent();
      Guard(this, [](Window& self) { self.TakeTurn(); });
    }
    glut_.Exit();
    if (failure_) std::rethrow_exception(failure_);
    return exit_code_;
  }

 private:
  void Open();
  void ListenToKeys();

  // Between events.
  void TakeTurn();
  void TakeNews();
  void Draw();
  void Ask();
  void Wait();

  // What the callbacks do.
  void Resize(PixelSize window);
  void Press(const std::string& key);
  void Release(const std::string& key);

  void ReleaseLostKeys();
  void FollowScene();
  void SavePicture();
  void Close();

  /// freeglut is C: no exception may pass through its loop.
  template <typename Work>
  static void Guard(void* window, Work work) {
    auto* self = static_cast<Window*>(window);
    try {
      work(*self);
    } catch (...) {
      if (!self->failure_) self->failure_ = std::current_exception();
      self->Close();
    }
  }

  Bell bell_;
  Simulation simulation_;
  std::function<bool()> interrupted_;
  Display display_;
  UiScale ui_scale_;
  GlutFunctions glut_;
  std::unique_ptr<Screen> screen_;

  MessageBoard board_;
  std::set<std::string> held_;  // keys that are down
  unsigned long focus_ = 0;     // the window that got the first of them
  void* connection_ = nullptr;  // freeglut's, to the X server
  Stopwatch clock_;
  bool is_stale_ = true;  // the window shows something else than it should
  bool has_asked_ = false;
  double asked_at_ = 0;  // [s] on clock_
  double next_ask_ = 0;
  std::string shown_message_;
  long shown_scene_ = 0;  // numbers of the moment that was taken last
  long presses_ = 0;
  long saves_ = 0;
  std::exception_ptr failure_;
  ExitCode exit_code_ = ExitCode::kDone;
};

void Window::Open() {
  int count = 1;
  std::array<char, 7> program = {"sphlab"};
  std::array<char*, 2> arguments = {program.data(), nullptr};
  const Display::Opening opening;
  glut_.InitErrorFunc(&RefuseGlutError);
  glut_.Init(&count, arguments.data());
  glut_.SetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
  glut_.InitContextVersion(3, 3);
  glut_.InitContextProfile(GLUT_CORE_PROFILE);
  glut_.InitDisplayMode(GLUT_RGBA | GLUT_DOUBLE);
  const PixelSize screen{glut_.Get(GLUT_SCREEN_WIDTH), glut_.Get(GLUT_SCREEN_HEIGHT)};
  const PixelSize size = FirstWindowSize(simulation_.Now().content, screen, ui_scale_.For(1, 1));
  glut_.InitWindowSize(size.width, size.height);
  {
    const Display::Forgiving without_ending_the_program(display_);  // but with RefuseGlutError
    glut_.CreateWindow(simulation_.Now().window_title.c_str());
  }
  try {
    screen_ = std::make_unique<Screen>(
        [this](const char* name) { return reinterpret_cast<void*>(glut_.GetProcAddress(name)); }, ui_scale_);
  } catch (...) {
    glut_.Exit();
    throw;
  }
  Resize(size);
  FollowScene();
  board_.Show(simulation_.Now().scene_title + "\nh shows what the keys do", clock_.Seconds());
  glut_.ReshapeFuncUcall(
      [](int width, int height, void* w) { Guard(w, [&](Window& s) {
                                             s.Resize({width, height});
                                           }); }, this);
  glut_.DisplayFuncUcall([](void* w) { Guard(w, [](Window& s) { s.is_stale_ = true; }); }, this);
  glut_.CloseFuncUcall([](void* w) { Guard(w, [](Window& s) { s.Close(); }); }, this);
}

void Window::ListenToKeys() {
  // A key that is held is pressed once. freeglut, told to ignore repeats, asks whether the key is down now; in a slow
  // frame it would take two quick taps for one. So the server marks repeats, and Press knows what is down.
  const auto glut_connection = reinterpret_cast<void* (*)()>(glut_.GetProcAddress("glXGetCurrentDisplay"));
  if (glut_connection != nullptr) connection_ = glut_connection();
  const bool marked = connection_ != nullptr && display_.ReportRepeatsAsPresses(connection_);
  glut_.IgnoreKeyRepeat(marked ? 0 : 1);
  glut_.KeyboardFuncUcall(
      [](unsigned char code, int, int, void* w) { Guard(w, [&](Window& s) { s.Press(NameOfKey(code)); }); }, this);
  glut_.KeyboardUpFuncUcall(
      [](unsigned char code, int, int, void* w) { Guard(w, [&](Window& s) { s.Release(NameOfKey(code)); }); }, this);
  glut_.SpecialFuncUcall(
      [](int code, int, int, void* w) { Guard(w, [&](Window& s) { s.Press(NameOfSpecialKey(code)); }); }, this);
  glut_.SpecialUpFuncUcall(
      [](int code, int, int, void* w) { Guard(w, [&](Window& s) { s.Release(NameOfSpecialKey(code)); }); }, this);
}

void Window::Resize(PixelSize window) {
  if (!screen_) return;
  screen_->Resize(window);
  is_stale_ = true;
}

void Window::TakeTurn() {
  if (!screen_) return;
  if (interrupted_ && interrupted_()) {
    exit_code_ = ExitCode::kInterrupted;
    Close();
    return;
  }
  ReleaseLostKeys();
  TakeNews();
  if (!screen_) return;
  // A frame without what the last key does would only delay the one with it.
  if (simulation_.IsUpToDate() && (is_stale_ || board_.Read(clock_.Seconds()) != shown_message_)) Draw();
  Ask();
  Wait();
}

void Window::TakeNews() {
  if (!simulation_.Take()) return;
  has_asked_ = false;
  is_stale_ = true;
  const Moment& moment = simulation_.Now();
  if (moment.quit) {
    Close();
    return;
  }
  FollowScene();
  if (std::exchange(presses_, moment.presses) != moment.presses) board_.Show(moment.message, clock_.Seconds());
  if (std::exchange(saves_, moment.saves) != moment.saves) SavePicture();
}

/// Draws, and leaves the processors to the simulation for as long as that took before it asks for another moment: where
/// they are what draws, a frame of many particles takes all of them. What keys do is drawn at once all the same.
void Window::Draw() {
  const double start = clock_.Seconds();
  shown_message_ = board_.Read(start);
  screen_->Draw(simulation_.Now(), shown_message_);
  const double drawn = clock_.Seconds();
  glut_.SwapBuffers();
  simulation_.NoteShown(drawn - start);
  is_stale_ = false;
  next_ask_ = std::max(asked_at_ + kFrame, drawn + (drawn - start));
}

/// Asks for the next moment when a frame is due.
void Window::Ask() {
  const double now = clock_.Seconds();
  if (has_asked_ || now < next_ask_) return;
  has_asked_ = true;
  asked_at_ = std::max(next_ask_, now - kFrame);  // a little late is no reason for fewer frames
  simulation_.AskForNews();
}

/// Until there is an event, news, or something to look after: keys, messages, an interrupt.
void Window::Wait() {
  if (connection_ != nullptr && display_.HasEvents(connection_)) return;
  const double until_ask = has_asked_ ? kFrame : std::min(kFrame, next_ask_ - clock_.Seconds());
  bell_.Wait(connection_ != nullptr ? display_.Descriptor(connection_) : -1, until_ask);
}

void Window::Press(const std::string& key) {
  if (key.empty() || !screen_) return;
  if (held_.empty()) focus_ = display_.Focus();
  if (!held_.insert(key).second) return;  // a repeat
  simulation_.Press(key);
}

void Window::Release(const std::string& key) {
  if (!screen_) return;
  const auto acts_while_held = [](const std::string& other) {
    const Control* control = FindControl(other);
    return control != nullptr && control->release != nullptr;
  };
  if (held_.erase(key) == 0) {
    // It has another name than when it was pressed: Shift came or went. No use in keeping what may be up.
    std::erase_if(held_, [&](const std::string& other) { return !acts_while_held(other); });
    return;
  }
  if (!acts_while_held(key)) return;
  simulation_.Release(key);
  for (const std::string& other : held_) {
    if (acts_while_held(other)) simulation_.Press(other);  // of two arrows, the one still held goes on
  }
}

/// Keys that are down when another window gets the keys are let go there: here nobody hears of it.
void Window::ReleaseLostKeys() {
  if (held_.empty() || display_.Focus() == focus_) return;
  for (const std::string& key : held_) simulation_.Release(key);
  held_.clear();
}

/// Shows another scene whole, under its own title.
void Window::FollowScene() {
  const Moment& moment = simulation_.Now();
  if (std::exchange(shown_scene_, moment.scene_number) == moment.scene_number) return;
  screen_->Fit(moment.content);
  glut_.SetWindowTitle(moment.window_title.c_str());
}

void Window::SavePicture() {
  std::string message;
  try {
    const auto file = NextPictureName(std::filesystem::current_path(), simulation_.Now().scene_name);
    WritePng(file, screen_->TakePicture(simulation_.Now()));
    message = "saved " + file.string();
  } catch (const std::exception& error) {
    message = error.what();  // a full disk is no reason to end the simulation
  }
  board_.Show(std::move(message), clock_.Seconds());
}

/// Deletes what needs the context, which is current in every callback and between them; Run then returns.
void Window::Close() {
  if (!screen_) return;
  screen_.reset();
  KeepLoadedLibraries();
}

}  // namespace

ExitCode RunWindow(const SceneRequest& request, const std::function<bool()>& interrupted) {
  KeepFreedMemory();
  return Window(request, interrupted).Run();
}

}  // namespace sph
