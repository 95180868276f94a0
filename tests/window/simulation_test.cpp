// A session in its own thread: what it shows, what keys do, and that it goes on by itself.
#include "window/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "window/bell.hpp"
#include "window/watched_window.hpp"

namespace sph {
namespace {

/// A simulation, and who looks at it.
struct Watched {
  explicit Watched(const std::string& scene = "dam-break", double time_step = 0)
      : simulation(
            [&] {
              SceneRequest request;
              request.scene = scene;
              request.particles = 100;
              request.threads = 1;
              if (time_step > 0) request.settings = {fmt::format("method.time_step={}", time_step), "method.retries=0"};
              return request;
            }(),
            [this] { bell.Ring(); }) {}

  /// Looks at news, as the window does, until they are as expected.
  bool Sees(const std::function<bool(const Moment&)>& expected) {
    return Eventually([&] {
      simulation.AskForNews();
      bell.Wait(-1, 0.1);
      if (simulation.Take()) simulation.NoteShown(0);
      return expected(simulation.Now());
    });
  }
  bool SeesStatus(const std::string& part) {
    return Sees([&](const Moment& moment) { return moment.status.find(part) != std::string::npos; });
  }

  Bell bell;
  Simulation simulation;
};

TEST(Simulation, ShowsItsStartBeforeItRuns) {
  Watched watched;
  const Moment& moment = watched.simulation.Now();
  EXPECT_NE(moment.status.find("N 100   t 0.000 s   step 0"), std::string::npos) << moment.status;
  EXPECT_EQ(moment.window_title, "sphlab: dam-break");
  EXPECT_EQ(moment.scene_name, "dam-break");
  EXPECT_EQ(moment.snapshot.WantedColouring(), Colouring::kBlackDisks);
  EXPECT_TRUE(moment.help.empty());
  EXPECT_TRUE(watched.simulation.IsUpToDate());
  EXPECT_FALSE(watched.simulation.Take());
}

TEST(Simulation, GoesOnByItselfAndKeepsPaceWithTheClock) {
  Watched watched;
  const Stopwatch watch;
  watched.simulation.Start();
  EXPECT_TRUE(watched.SeesStatus("t 0.5"));
  EXPECT_GT(watch.Seconds(), 0.49) << "not ahead of it";
}

TEST(Simulation, SaysNothingUnasked) {
  Watched watched;
  watched.simulation.Start();
  watched.bell.Wait(-1, 0.1);
  EXPECT_FALSE(watched.simulation.Take());
}

TEST(Simulation, SaysUnaskedWhatAKeyDoes) {
  Watched watched;
  watched.simulation.Start();
  watched.simulation.Press("c");
  EXPECT_FALSE(watched.simulation.IsUpToDate());
  EXPECT_TRUE(Eventually([&] { return watched.simulation.Take(); }));
  EXPECT_TRUE(watched.simulation.IsUpToDate());
  EXPECT_EQ(watched.simulation.Now().message, "colouring: speed");
  EXPECT_EQ(watched.simulation.Now().snapshot.WantedColouring(), Colouring::kSpeed);
}

TEST(Simulation, StandsWhilePausedAndMakesTheStepsAskedFor) {
  Watched watched;
  watched.simulation.Press("p");
  watched.simulation.Start();
  EXPECT_TRUE(watched.SeesStatus("step 0   paused"));
  for (int key = 0; key < 3; ++key) watched.simulation.Press(".");
  EXPECT_TRUE(watched.SeesStatus("step 3   paused"));
  watched.simulation.Press("p");
  EXPECT_TRUE(watched.Sees([](const Moment& m) { return m.status.find("paused") == std::string::npos; }));
  EXPECT_TRUE(watched.Sees([](const Moment& m) { return m.status.find("step 3 ") == std::string::npos; }));
}

TEST(Simulation, MakesUpForNoPause) {
  Watched watched;
  watched.simulation.Press("p");
  watched.simulation.Start();
  EXPECT_TRUE(watched.SeesStatus("paused"));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  watched.simulation.Press("p");
  watched.simulation.Press("p");
  EXPECT_TRUE(watched.Sees([](const Moment& moment) { return moment.presses == 3; }));
  EXPECT_TRUE(watched.SeesStatus("t 0.0")) << watched.simulation.Now().status;
}

TEST(Simulation, CountsWhatMustNotBePassedOver) {
  Watched watched;
  watched.simulation.Start();
  const long scene = watched.simulation.Now().scene_number;
  for (const char* key : {"s", "h", "]", "s"}) watched.simulation.Press(key);
  EXPECT_TRUE(watched.Sees([](const Moment& moment) { return moment.presses == 4; }));
  const Moment& moment = watched.simulation.Now();
  EXPECT_EQ(moment.scene_number, scene + 1);
  EXPECT_NE(moment.window_title, "sphlab: dam-break");
  EXPECT_EQ(moment.saves, 2);
  EXPECT_FALSE(moment.help.empty());
  EXPECT_FALSE(moment.quit);
  watched.simulation.Press("q");
  EXPECT_TRUE(watched.Sees([](const Moment& m) { return m.quit; }));
}

TEST(Simulation, StopsWithItsReasonWhenItBecomesUnstableAndStartsAfreshWithR) {
  Watched watched("dam-break", 0.05);
  watched.simulation.Start();
  EXPECT_TRUE(watched.Sees([](const Moment& moment) { return !moment.standing.empty(); }));
  EXPECT_NE(watched.simulation.Now().status.find("stopped"), std::string::npos);
  watched.simulation.Press("r");
  EXPECT_TRUE(watched.Sees([](const Moment& moment) { return moment.presses == 1 && moment.standing.empty(); }));
}

TEST(Simulation, EndsWhileKeysAndQuestionsAreOpen) {
  for (int time = 0; time < 20; ++time) {
    Watched watched;
    watched.simulation.Start();
    watched.simulation.AskForNews();
    watched.simulation.Press("c");
    watched.simulation.Press("space");
  }
}

}  // namespace
}  // namespace sph
