// The real window as a whole: what it shows, how it opens and why not, how it ends.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "window/watched_window.hpp"

namespace sph {
namespace {

constexpr Box kColumn{-0.9, -0.9, -0.4, -0.6};

bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Are floor and left wall of the dam break where equal scales in both directions put them?
bool WallsAreInPlace(const WatchedWindow& window, const Image& image) {
  const double pixel = 1 / window.ViewIn(image).Scale();
  const Box floor{-0.9, -0.95 - pixel, -0.4, -0.95 + pixel};
  const Box ceiling{-0.9, 0.95 - pixel, -0.4, 0.95 + pixel};
  const Box left{-0.95 - pixel, 0.2, -0.95 + pixel, 0.9};
  const Box above{-0.9, 0.95 + 4 * pixel, -0.4, 0.95 + 6 * pixel};
  return window.Darkness(image, floor) > 0.9 && window.Darkness(image, ceiling) > 0.9 &&
         window.Darkness(image, left) > 0.9 && window.Darkness(image, above) < 0.1;
}

TEST(Window, ShowsDisksWallsStatusLineAndTitle) {
  const WatchedWindow window;
  const Image image = window.Look();
  EXPECT_EQ(window.Title(), "sphlab: dam-break");
  EXPECT_TRUE(WallsAreInPlace(window, image));
  EXPECT_GT(window.Darkness(image, kColumn), 0.02);
  EXPECT_LT(window.Darkness(image, kColumn), 0.9);
  const auto is_dark = [](int red, int, int) { return red < 100; };
  EXPECT_GT(CountPixels(Rows(image, 0, 35), is_dark), 200);
}

TEST(Window, KeepsScalesEqualInWindowsOfAnyShape) {
  WatchedWindow window;
  for (const auto& [width, height] : {std::pair{300, 1000}, {1200, 500}, {900, 900}}) {
    window.Screen().Resize(window.Id(), width, height);
    const auto as_asked = [&, w = width, h = height] {
      const Image image = window.Look();
      return image.width == w && image.height == h && WallsAreInPlace(window, image);
    };
    EXPECT_TRUE(Eventually(as_asked)) << width << " x " << height;
  }
}

TEST(Window, EndsWithQAndLeavesNothingToSay) {
  WatchedWindow window;
  window.Press("q");
  EXPECT_EQ(window.Program().WaitForEnd(), 0);
  EXPECT_EQ(window.Program().Output(), "");
}

TEST(Window, EndsWithEscape) {
  WatchedWindow window;
  window.Press("Escape");
  EXPECT_EQ(window.Program().WaitForEnd(), 0);
}

TEST(Window, EndsWhenItIsClosed) {
  WatchedWindow window;
  window.Screen().AskToClose(window.Id());
  EXPECT_EQ(window.Program().WaitForEnd(), 0);
  EXPECT_EQ(window.Program().Output(), "");
}

TEST(Window, EndsWithControlC) {
  WatchedWindow window;
  window.Program().Signal(SIGINT);
  EXPECT_EQ(window.Program().WaitForEnd(), 130);
}

TEST(Window, AnUnstableSimulationStopsWithItsReasonAndRResetsIt) {
  const WatchedWindow window("dam-break", {"--set", "method.time_step=0.02", "--set", "method.retries=0"});
  constexpr Box kBelow{-0.5, -1.2, 0.5, -0.98};  // where messages stand
  const Image stopped = window.LookWhenStill();
  EXPECT_GT(window.Darkness(stopped, kBelow), 0.3);
  window.Press("r");
  EXPECT_TRUE(Eventually([&] { return window.Look() != stopped; }));
}

TEST(Window, APausedOneLeavesTheProcessorAlone) {
  WatchedWindow window;
  window.PressAndSeeMessage("p");
  window.LookWhenStill();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const double before = window.Program().ProcessorSeconds();
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_LT(window.Program().ProcessorSeconds() - before, 0.2);  // a tenth of a core
}

TEST(Window, SaysWithoutADisplayWhatToDo) {
  for (const char* display : {"", ":31415"}) {
    RunningProgram program({"toy-star"}, {{"DISPLAY", display}});
    EXPECT_EQ(program.WaitForEnd(), 1);
    const std::string said = program.Output();
    for (const char* part : {"no display", "DISPLAY", display, "sphlab render toy-star --out"}) {
      EXPECT_TRUE(Has(said, part)) << part << " in: " << said;
    }
  }
}

TEST(Window, AWrongSceneGoesBeforeAMissingDisplay) {
  RunningProgram program({"toy-stra"}, {{"DISPLAY", ""}});
  EXPECT_EQ(program.WaitForEnd(), 2);
  EXPECT_TRUE(Has(program.Output(), "toy-star"));
}

TEST(Window, SaysThatTheDisplayHasNoOpenGl) {
  const HiddenDisplay display({"-extension", "GLX"});
  RunningProgram program({}, {{"DISPLAY", display.Name()}});
  EXPECT_EQ(program.WaitForEnd(), 1);
  EXPECT_TRUE(Has(program.Output(), "GLX")) << program.Output();
}

TEST(Window, SaysThatItsOpenGlIsTooOld) {
  const HiddenDisplay display;
  RunningProgram program({}, {{"DISPLAY", display.Name()}, {"MESA_GL_VERSION_OVERRIDE", "2.1"}});
  EXPECT_EQ(program.WaitForEnd(), 1);
  EXPECT_TRUE(Has(program.Output(), "OpenGL 3.3")) << program.Output();
}

TEST(Window, ARunWithoutOneLoadsNothingOfTheScreen) {
  RunningProgram program({"run", "dam-break", "--steps", "2"}, {{"LD_DEBUG", "files"}});
  EXPECT_EQ(program.WaitForEnd(), 0);
  const std::string loaded = program.Output();
  EXPECT_TRUE(Has(loaded, "libc.so")) << "the loader says nothing here";
  for (const char* library : {"libGL", "libglut", "libOSMesa", "libEGL"}) EXPECT_FALSE(Has(loaded, library)) << library;
}

}  // namespace
}  // namespace sph
