// `sphlab render`: which frames it writes, and what can be seen on them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands/pictures.hpp"
#include "commands/program.hpp"
#include "io/png.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Renders into `folder`; the report in JSON.
json Render(const fs::path& folder, Program::Arguments arguments) {
  const Program::Arguments always = {"--out", folder, "--threads", "1", "--json", "--quiet"};
  arguments.insert(arguments.begin(), "render");
  arguments.insert(arguments.end(), always.begin(), always.end());
  const Outcome outcome = RunProgram(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out, nullptr, false);
}

Image Frame(const fs::path& folder, int number) { return ReadPng(folder / fmt::format("frame_{:06}.png", number)); }

std::vector<std::string> Names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Render, WritesFramesOfTheirNumberNamesAndSize) {
  const ScratchDirectory scratch;
  const fs::path out = scratch.Path() / "new/folder";
  const json report = Render(out, {"dam-break", "--frames", "3", "--fps", "50", "--size", "200x100"});
  EXPECT_EQ(Names(out), (std::vector<std::string>{"frame_000000.png", "frame_000001.png", "frame_000002.png"}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(Frame(out, i).width, 200);
    EXPECT_EQ(Frame(out, i).height, 100);
  }
  EXPECT_EQ(report["frames"], 3);
  EXPECT_EQ(report["width"], 200);
  EXPECT_EQ(report["height"], 100);
  EXPECT_EQ(report["backend"], "osmesa");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_NEAR(report["time"].get<double>(), 0.04, 1e-9);
  for (const char* thread : {"drawing_seconds", "writing_seconds"}) EXPECT_GT(report[thread].get<double>(), 0);
}

TEST(Render, EndsWhereFramesOrTimeEndWhicheverComesFirst) {
  const auto frames = [](const Program::Arguments& arguments) {
    const ScratchDirectory scratch;
    Program::Arguments all = {"dam-break", "--size", "60x60"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return Render(scratch.Path(), all)["frames"].get<int>();
  };
  EXPECT_EQ(frames({"--until", "0.2", "--fps", "10"}), 3) << "at 0, 0.1 and 0.2 s";
  EXPECT_EQ(frames({"--until", "0.2", "--fps", "10", "--frames", "2"}), 2);
  EXPECT_EQ(frames({"--until", "0.2", "--fps", "10", "--frames", "9"}), 3);
  EXPECT_EQ(frames({"--frames", "2", "--fps", "10", "--keys", "0.05:q"}), 1) << "q ends it";
}

TEST(Render, SavesOneMorePictureForTheKeyS) {
  const ScratchDirectory scratch;
  Render(scratch.Path(), {"dam-break", "--frames", "2", "--fps", "10", "--size", "60x60", "--keys", "0.02:s"});
  EXPECT_EQ(Names(scratch.Path()),
            (std::vector<std::string>{"frame_000000.png", "frame_000001.png", "saved_000001.png"}));
}

TEST(Render, EndsWithAMessageWhenItsFolderGoesAway) {
  const ScratchDirectory scratch;
  const fs::path out = scratch.Path() / "out";
  Program program({"render", "--out", out, "--until", "1e6", "--size", "60x60", "--keys", "0.1:c", "--json"});
  ASSERT_TRUE(program.Says("colouring"));
  fs::rename(out, scratch.Path() / "elsewhere");
  const Outcome outcome = program.Wait();
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("cannot write " + (out / "frame_").string()), std::string::npos) << outcome.err;
}

TEST(Render, OfAnUnstableSceneWritesNoFrameOfItAndExitsWithThree) {
  const ScratchDirectory scratch;
  const Outcome outcome = RunProgram({"render", "--set", "method.time_step=0.05", "--set", "method.retries=0", "--out",
                                      scratch.Path(), "--size", "60x60"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("unstable: step "), std::string::npos) << outcome.err;
  EXPECT_EQ(Names(scratch.Path()), std::vector<std::string>{"frame_000000.png"}) << "the start is sound";
}

TEST(Render, DrawsTheSamePixelsWithOsmesaAndEgl) {
  const ScratchDirectory osmesa, egl;
  const Program::Arguments what = {"dam-break", "--frames", "3", "--fps", "10", "--keys", "0.05:d,0.15:c"};
  const auto with = [&](const fs::path& folder, const char* name) {
    Program::Arguments arguments = what;
    arguments.insert(arguments.end(), {"--backend", name});
    return Render(folder, arguments);
  };
  const json in_osmesa = with(osmesa.Path(), "osmesa"), in_egl = with(egl.Path(), "egl");
  EXPECT_EQ(in_osmesa["backend"], "osmesa");
  EXPECT_EQ(in_egl["backend"], "egl");
  if (in_osmesa["gl"] != in_egl["gl"]) GTEST_SKIP() << "EGL draws with another driver here: " << in_egl["gl"];
  for (int i = 0; i < 3; ++i) EXPECT_EQ(Frame(osmesa.Path(), i), Frame(egl.Path(), i)) << "frame " << i;
  EXPECT_NE(Frame(egl.Path(), 0), Frame(egl.Path(), 1));
}

TEST(Render, ChangesTheColouringWithC) {
  const ScratchDirectory scratch;
  Render(scratch.Path(), {"dam-break", "--frames", "2", "--fps", "10", "--size", "300x300", "--keys", "0.05:c"});
  const auto colourful = [](const Image& image) {
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      if (image.rgb[i] != image.rgb[i + 2]) return true;
    }
    return false;
  };
  EXPECT_FALSE(colourful(Frame(scratch.Path(), 0)));
  EXPECT_TRUE(colourful(Frame(scratch.Path(), 1)));
}

/// Ink in the columns between two walls, without the walls themselves.
double InkBetweenWalls(const Image& image, double left, double right) {
  constexpr int kWallWidth = 6;  // [pixels], more than that
  return InkBetween(image, static_cast<int>(left) + kWallWidth, static_cast<int>(right) - kWallWidth);
}

/// In frame `before` all is black to the left of the dam and nothing to its right; in frame `after` the fluid is
/// on both sides.
void ExpectTheDamBreaks(const Program::Arguments& arguments, int before, int after) {
  const ScratchDirectory scratch;
  Render(scratch.Path(), arguments);
  const Image still = Frame(scratch.Path(), before), broken = Frame(scratch.Path(), after);
  const int tall = still.height / 2;
  const std::vector<double> closed = VerticalLines(still, tall), open = VerticalLines(broken, tall);
  ASSERT_EQ(closed.size(), 2u) << "left wall and dam";
  ASSERT_EQ(open.size(), 2u) << "left wall and the dam at its far place";
  EXPECT_EQ(closed[0], open[0]) << "the left wall stays";
  // From -0.95 m to -0.35 m, and to 0.95 m; a line is a few whole pixels wide.
  const double left = closed[0], dam = closed[1], far = open[1];
  EXPECT_NEAR((dam - left) / (far - left), 0.6 / 1.9, 2 / (far - left));
  const double contained = InkBetweenWalls(still, left, dam);
  EXPECT_GT(contained, 0.15 * (dam - left) * (dam - left)) << "the fluid is about as wide as it is high";
  EXPECT_EQ(InkBetweenWalls(still, dam, far), 0) << "nothing leaks through the dam";
  EXPECT_LT(InkBetweenWalls(broken, left, dam), 0.8 * contained);
  EXPECT_GT(InkBetweenWalls(broken, dam, far), 0.3 * contained);
  EXPECT_GT(InkBetweenWalls(broken, far - 0.2 * (far - left), far), 0) << "it reaches the far wall";
}

TEST(Render, BreaksTheDamAtTheTimeOfItsKey) {
  ExpectTheDamBreaks({"dam-break", "--keys", "1:d", "--until", "2", "--fps", "2", "--size", "500x500"}, 1, 4);
}

TEST(Render, SlowBreaksTheSettledDam) {
  ExpectTheDamBreaks({"dam-break", "--keys", "4:d", "--until", "6", "--fps", "10", "--size", "500x500"}, 39, 60);
}

TEST(Render, SlowOfManyParticlesAndColoursIsTheSameWithEitherBackEnd) {
  const ScratchDirectory osmesa, egl;
  const auto with = [&](const fs::path& folder, const char* name) {
    return Render(folder, {"toy-star", "--particles", "16000", "--frames", "4", "--fps", "100", "--keys",
                           "0.005:c,0.015:c,0.025:c", "--size", "1280x720", "--backend", name});
  };
  if (with(osmesa.Path(), "osmesa")["gl"] != with(egl.Path(), "egl")["gl"]) GTEST_SKIP() << "another driver";
  for (int i = 0; i < 4; ++i) EXPECT_EQ(Frame(osmesa.Path(), i), Frame(egl.Path(), i)) << "frame " << i;
}

TEST(Figures, SlowAreMadeByOneCommand) {
  const ScratchDirectory scratch;
  EXPECT_EQ(RunProgram({"figures", "--out", scratch.Path()}).exit_code, 0);
  EXPECT_EQ(Names(scratch.Path()), (std::vector<std::string>{"figure1.png", "figure2.png", "figure3.png"}));
  for (const std::string& name : Names(scratch.Path())) {
    const Image figure = ReadPng(scratch.Path() / name);
    EXPECT_GE(figure.width, 640) << name;
    EXPECT_GE(figure.height, 400) << name;
    EXPECT_GT(InkBetween(figure, 0, figure.width), 0.01 * figure.width * figure.height) << name;
  }
}

}  // namespace
}  // namespace sph
