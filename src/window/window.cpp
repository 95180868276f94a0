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

#include "base/clock.hpp"
#include "base/library.hpp"
#include "io/png.hpp"
#include "scenes/build.hpp"
#include "window/controls.hpp"
#include "window/display.hpp"
#include "window/glut_library.hpp"
#include "window/key_names.hpp"
#include "window/message_board.hpp"
#include "window/pace.hpp"
#include "window/picture_name.hpp"
#include "window/screen.hpp"
#include "window/words.hpp"

namespace sph {
namespace {

constexpr double kFrame = 1.0 / 60;    // [s]
constexpr double kStepBudget = 0.012;  // [s] of a frame; the rest is for drawing

/// freeglut calls this instead of ending the program; it passes the exception on, as its frames have unwind tables.
void RefuseGlutError(const char* format, va_list arguments) {
  std::array<char, 1000> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  throw TroubleError("the window does not open: {}\nsphlab needs an X display with GLX and OpenGL 3.3 core.",
                     text.data());
}

/// freeglut's callbacks; it owns window and context. What must be deleted while the context is current is in `screen_`.
class Window {
 public:
  Window(const SceneRequest& request, std::function<bool()> interrupted)
      : session_(request),
        interrupted_(std::move(interrupted)),
        display_(
            fmt::format("Without one, `sphlab render {} --out frames` draws the scene to PNG files.", request.scene)),
        ui_scale_(display_.DotsPerInch()),
        glut_(LoadGlut()) {}

  ExitCode Run() {
    Open();
    ListenToKeys();
    ArmTimer();
    glut_.MainLoop();
    if (failure_) std::rethrow_exception(failure_);
    return exit_code_;
  }

 private:
  void Open();
  void ListenToKeys();
  void ArmTimer();

  // What the callbacks do.
  void Resize(PixelSize window);
  void Tick();
  void Draw();
  void Press(const std::string& key);
  void Release(const std::string& key);

  void ReleaseLostKeys();
  void ShowMessage();
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

  Session session_;
  std::function<bool()> interrupted_;
  Display display_;
  UiScale ui_scale_;
  GlutFunctions glut_;
  std::unique_ptr<Screen> screen_;

  Pace pace_{kStepBudget};
  RateMeter meter_;
  MessageBoard board_;
  std::set<std::string> held_;  // keys that are down
  unsigned long focus_ = 0;     // the window that got the first of them
  Stopwatch clock_;
  double last_tick_ = 0;  // [s] on clock_
  double next_tick_ = 0;
  std::string shown_message_;
  const ParticleSystemSPH* shown_system_ = nullptr;
  std::exception_ptr failure_;
  ExitCode exit_code_ = ExitCode::kDone;
};

void Window::Open() {
  int count = 1;
  std::array<char, 7> program = {"sphlab"};
  std::array<char*, 2> arguments = {program.data(), nullptr};
  glut_.InitErrorFunc(&RefuseGlutError);
  glut_.Init(&count, arguments.data());
  glut_.SetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
  glut_.InitContextVersion(3, 3);
  glut_.InitContextProfile(GLUT_CORE_PROFILE);
  glut_.InitDisplayMode(GLUT_RGBA | GLUT_DOUBLE);
  const PixelSize screen{glut_.Get(GLUT_SCREEN_WIDTH), glut_.Get(GLUT_SCREEN_HEIGHT)};
  const PixelSize size = FirstWindowSize(InitialView(session_.CurrentScene()), screen, ui_scale_.For(1, 1));
  glut_.InitWindowSize(size.width, size.height);
  {
    const Display::Forgiving without_ending_the_program(display_);  // but with RefuseGlutError
    glut_.CreateWindow(WindowTitle(session_).c_str());
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
  board_.Show(session_.CurrentScene().title + "\nh shows what the keys do", clock_.Seconds());
  glut_.ReshapeFuncUcall(
      [](int width, int height, void* w) { Guard(w, [&](Window& s) {
                                             s.Resize({width, height});
                                           }); }, this);
  glut_.DisplayFuncUcall([](void* w) { Guard(w, [](Window& s) { s.Draw(); }); }, this);
  glut_.CloseFuncUcall([](void* w) { Guard(w, [](Window& s) { s.Close(); }); }, this);
}

void Window::ListenToKeys() {
  // A key that is held is pressed once. freeglut, told to ignore repeats, asks whether the key is down now; in a slow
  // frame it would take two quick taps for one. So the server marks repeats, and Press knows what is down.
  const auto glut_connection = reinterpret_cast<void* (*)()>(glut_.GetProcAddress("glXGetCurrentDisplay"));
  const bool marked = glut_connection != nullptr && display_.ReportRepeatsAsPresses(glut_connection());
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

/// The next tick is a frame after the last one was due; at once, events in between, if that is over.
void Window::ArmTimer() {
  const double now = clock_.Seconds();
  next_tick_ = std::max(next_tick_ + kFrame, now);
  const auto wait_ms = static_cast<unsigned>(1000 * (next_tick_ - now));
  glut_.TimerFuncUcall(
      wait_ms, [](int, void* w) { Guard(w, [](Window& s) { s.Tick(); }); }, 0, this);
}

void Window::Resize(PixelSize window) {
  if (!screen_) return;
  screen_->Resize(window);
  glut_.PostRedisplay();
}

void Window::Tick() {
  if (!screen_) return;
  if (interrupted_ && interrupted_()) {
    exit_code_ = ExitCode::kInterrupted;
    Close();
    return;
  }
  ReleaseLostKeys();
  const double now = clock_.Seconds();
  const int steps = pace_.Advance(session_, now - last_tick_);
  last_tick_ = now;
  meter_.CountSteps(steps);
  const bool runs = !session_.paused && !session_.System().Trouble();
  if (runs || steps > 0 || board_.Read(now) != shown_message_) glut_.PostRedisplay();
  ArmTimer();
}

void Window::Draw() {
  if (!screen_) return;
  if (session_.save_requested) SavePicture();
  const double now = clock_.Seconds();
  shown_message_ = board_.Read(now);
  screen_->Draw(session_, meter_.Read(now, session_.System().Time()), shown_message_);
  glut_.SwapBuffers();
  meter_.CountFrame();
}

void Window::Press(const std::string& key) {
  if (key.empty() || !screen_) return;
  if (held_.empty()) focus_ = display_.Focus();
  if (!held_.insert(key).second) return;  // a repeat
  board_.Show({}, clock_.Seconds());
  PressKey(session_, key);
  if (session_.quit_requested) {
    Close();
    return;
  }
  ShowMessage();
  FollowScene();
  glut_.PostRedisplay();
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
  ReleaseKey(session_, key);
  for (const std::string& other : held_) {
    if (acts_while_held(other)) PressKey(session_, other);  // of two arrows, the one still held goes on
  }
}

/// Keys that are down when another window gets the keys are let go there: here nobody hears of it.
void Window::ReleaseLostKeys() {
  if (held_.empty() || display_.Focus() == focus_) return;
  for (const std::string& key : held_) ReleaseKey(session_, key);
  held_.clear();
}

/// Takes what the session has to say to the message line.
void Window::ShowMessage() {
  if (session_.message.empty()) return;
  board_.Show(std::move(session_.message), clock_.Seconds());
  session_.message.clear();
}

/// Shows another scene whole, under its own title.
void Window::FollowScene() {
  if (shown_system_ == &session_.System()) return;
  shown_system_ = &session_.System();
  screen_->Fit(session_.CurrentScene());
  glut_.SetWindowTitle(WindowTitle(session_).c_str());
}

void Window::SavePicture() {
  session_.save_requested = false;
  try {
    const auto file = NextPictureName(std::filesystem::current_path(), session_.CurrentScene().name);
    WritePng(file, screen_->TakePicture(session_));
    session_.message = "saved " + file.string();
  } catch (const std::exception& error) {
    session_.message = error.what();  // a full disk is no reason to end the simulation
  }
  ShowMessage();
}

/// Deletes what needs the context, which is current in every callback, and has the main loop return.
void Window::Close() {
  if (!screen_) return;
  screen_.reset();
  KeepLoadedLibraries();
  glut_.LeaveMainLoop();
}

}  // namespace

ExitCode RunWindow(const SceneRequest& request, const std::function<bool()>& interrupted) {
  return Window(request, interrupted).Run();
}

}  // namespace sph
