#include "window/watched_window.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <sstream>
#include <thread>

#include "base/clock.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"
#include "window/camera.hpp"

namespace sph {
namespace {

constexpr double kPatience = 30;  // [s]
constexpr int kDark = 100;        // of 255
constexpr int kTextRows = 45;     // pixels of the status line, and of the message [pixels at UI scale 1]

void Pause() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

bool IsDark(const std::uint8_t* pixel) { return pixel[0] < kDark && pixel[1] < kDark && pixel[2] < kDark; }

}  // namespace

bool Eventually(const std::function<bool()>& question) {
  const Stopwatch watch;
  while (!question()) {
    if (watch.Seconds() > kPatience) return false;
    Pause();
  }
  return true;
}

RunningProgram::RunningProgram(const std::vector<std::string>& arguments,
                               const std::map<std::string, std::string>& environment) {
  std::vector<std::string> words = {SPHLAB_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const std::string output = directory_.Path() / "output";
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent || chdir(directory_.Path().c_str()) != 0) _exit(126);
  for (const auto& [name, value] : environment)
    value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
  const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  execv(pointers[0], pointers.data());
  _exit(127);
}

RunningProgram::~RunningProgram() {
  if (HasEnded()) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

bool RunningProgram::HasEnded() {
  if (process_ > 0 && waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
  return process_ < 0;
}

int RunningProgram::WaitForEnd() {
  if (!Eventually([this] { return HasEnded(); })) {
    ADD_FAILURE() << "the program goes on; it has said: " << Output();
    return -1;
  }
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
}

void RunningProgram::Signal(int signal) const { kill(process_, signal); }

double RunningProgram::ProcessorSeconds() const {
  std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::istringstream fields(text.substr(text.rfind(')') + 2));  // the name before may have spaces in it
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0;
  double kernel = 0;
  fields >> user >> kernel;
  return (user + kernel) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

WatchedWindow::WatchedWindow(const std::string& scene, const std::vector<std::string>& arguments)
    : scene_(scene),
      program_(
          [&] {
            std::vector<std::string> all = {scene};
            all.insert(all.end(), arguments.begin(), arguments.end());
            return all;
          }(),
          {{"DISPLAY", display_.Name()}, {"SPHLAB_UI_SCALE", "1"}}) {
  const bool opened = Eventually([this] {
    window_ = display_.FindWindow().value_or(0);
    return window_ != 0;
  });
  if (!opened) ADD_FAILURE() << "no window; the program has said: " << program_.Output();
  display_.BringForward(window_);
  const auto shows_something = [this] {
    return CountPixels(Look(), [](int red, int, int) { return red > 250; }) > 0 &&
           Darkness({-1e9, -1e9, 1e9, 1e9}) > 0.001;
  };
  EXPECT_TRUE(Eventually(shows_something)) << "the window stays empty: " << program_.Output();
}

void WatchedWindow::PressAndSeeMessage(const std::string& key) const {
  const auto message = [this] {
    const Image image = Look();
    return Rows(image, image.height - kTextRows, image.height);
  };
  const Image before = message();
  Press(key);
  EXPECT_TRUE(Eventually([&] { return message() != before; })) << key;
}

Image WatchedWindow::LookWhenStill() const {
  Image before;
  Image now = Look();
  const bool still = Eventually([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));  // several frames
    before = std::move(now);
    now = Look();
    return Rows(before, kTextRows, before.height - kTextRows) == Rows(now, kTextRows, now.height - kTextRows);
  });
  EXPECT_TRUE(still) << "it goes on moving";
  return now;
}

View WatchedWindow::ViewIn(const Image& image) const {
  SceneRequest request;
  request.scene = scene_;
  Camera camera;
  camera.Resize({image.width, image.height}, 1);
  camera.Fit(InitialView(LoadScene(request)));
  return camera.CurrentView();
}

double WatchedWindow::Darkness(const Image& image, const Box& box) const {
  const View view = ViewIn(image);
  const Vec2 low = view.ToPixel({box.x0, box.y1});
  const Vec2 high = view.ToPixel({box.x1, box.y0});
  const int left = static_cast<int>(std::clamp(low.x, 0.0, 1.0 * image.width));
  const int right = static_cast<int>(std::clamp(high.x, 0.0, 1.0 * image.width));
  const int top = static_cast<int>(std::clamp(low.y, 0.0, 1.0 * image.height));
  const int bottom = static_cast<int>(std::clamp(high.y, 0.0, 1.0 * image.height));
  int dark = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) dark += IsDark(image.Pixel(x, y)) ? 1 : 0;
  }
  return dark / std::max(1.0, 1.0 * (right - left) * (bottom - top));
}

std::optional<double> WatchedWindow::FindWall(const Box& box) const {
  const Image image = Look();
  if (image.width == 0) return std::nullopt;
  const double pixel = 1 / ViewIn(image).Scale();
  for (double x = box.x0; x < box.x1; x += pixel) {
    if (Darkness(image, {x - 0.51 * pixel, box.y0, x + 0.51 * pixel, box.y1}) > 0.99) return x;
  }
  return std::nullopt;
}

int CountPixels(const Image& image, const std::function<bool(int, int, int)>& is) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    count += is(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]) ? 1 : 0;
  }
  return count;
}

Image Rows(const Image& image, int top, int bottom) {
  const auto row = static_cast<std::ptrdiff_t>(3) * image.width;
  const int last = std::max(top, bottom);
  if (last > image.height) return {};
  return {image.width, last - top, {image.rgb.begin() + top * row, image.rgb.begin() + last * row}};
}

}  // namespace sph
