// Mistakes in a scene file: refused with file, line, column, what is accepted and the nearest name.
#include <fmt/format.h>

#include <algorithm>

#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

/// The dam break with one piece of its file replaced, and where in the file that is.
class ChangedScene {
 public:
  ChangedScene(const std::string& from, const std::string& to) {
    std::string text = Contents(std::filesystem::path(SPHLAB_SOURCE_DIR) / "assets/scenes/dam-break.toml");
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    std::ofstream(Path()) << text;
    const auto before = text.begin() + static_cast<std::ptrdiff_t>(place);
    line_ = 1 + std::count(text.begin(), before, '\n');
  }
  std::string Path() const { return scratch_.Path() / "changed.toml"; }
  /// "file:line:column" of a value in the line of the change.
  std::string Place(long column) const { return fmt::format("{}:{}:{}", Path(), line_, column); }

 private:
  ScratchDirectory scratch_;
  long line_ = 0;
};

testing::AssertionResult IsRefused(const ChangedScene& scene, long column, std::vector<std::string> says) {
  says.push_back(scene.Place(column));
  return Refuses(2, {"run", scene.Path(), "--steps", "1"}, says);
}

TEST(WrongScene, UnknownKeyIsNamedWithItsPlaceAndTheNearestOne) {
  EXPECT_TRUE(IsRefused({"smoothing_length = 0.068", "smoothing_lenght = 0.068"}, 20,
                        {"unknown key 'method.smoothing_lenght'", "'method.smoothing_length'?"}));
  EXPECT_TRUE(IsRefused({"range = [-0.75, 0.95]", "rnge = [-0.75, 0.95]"}, 8, {"unknown key 'wall.rnge'", "'range'?"}));
  EXPECT_TRUE(IsRefused({"press = \"d\"", "pres = \"d\""}, 8, {"unknown key 'key.pres'", "'press'?"}));
}

TEST(WrongScene, ImpossibleValueIsNamedWithWhatIsAccepted) {
  EXPECT_TRUE(IsRefused({"particles = 600", "particles = 0"}, 13, {"fluid.particles = 0", "a whole number from 1"}));
  EXPECT_TRUE(IsRefused({"time_step = 0.004", "time_step = -0.004"}, 13, {"method.time_step = -0.004", "> 0"}));
  EXPECT_TRUE(IsRefused({"time_step = 0.004", "time_step = nan"}, 13, {"method.time_step = nan", "a finite number"}));
  EXPECT_TRUE(IsRefused({"mass = 0.0033", "mass = inf"}, 8, {"fluid.mass = inf", "a finite number > 0"}));
  EXPECT_TRUE(IsRefused({"stiffness = 20000.0", "stiffness = -1"}, 13, {"walls.stiffness = -1", ">= 0"}));
}

TEST(WrongScene, ValueOfAnotherTypeIsNamedWithWhatIsAccepted) {
  EXPECT_TRUE(IsRefused({"particles = 600", "particles = \"many\""}, 13, {"fluid.particles = 'many'", "whole number"}));
  EXPECT_TRUE(IsRefused({"gravity = [0.0, -9.8]", "gravity = -9.8"}, 11, {"forces.gravity = -9.8", "[x, y]"}));
  EXPECT_TRUE(IsRefused({"arrange = \"random\"", "arrange = \"radnom\""}, 11, {"'radnom'", "jittered", "'random'?"}));
  EXPECT_TRUE(IsRefused({"solver = \"paper\"", "solver = \"papre\""}, 10, {"'papre'", "mueller", "'paper'?"}));
}

TEST(WrongScene, FileThatIsNoTomlIsNamedWithThePlace) {
  const ChangedScene scene("particles = 600", "particles = = 600");
  EXPECT_TRUE(IsRefused(scene, 13, {}));
}

TEST(WrongScene, MissingKeyIsNamedWithItsMeaning) {
  const ChangedScene scene("mass = 0.0033", "");
  EXPECT_TRUE(Refuses(2, {"run", scene.Path()}, {scene.Path(), "'fluid.mass' is missing", "[kg/m]"}));
}

TEST(WrongScene, WhatContradictsItselfIsRefused) {
  const ChangedScene far("wall = \"dam\"", "wall = \"damn\"");
  EXPECT_TRUE(Refuses(2, {"run", far.Path()}, {far.Path(), "names the wall 'damn'", "'dam'?"}));
  const ChangedScene key("set = \"forces.damping\"", "set = \"forces.gravity\"");
  EXPECT_TRUE(Refuses(2, {"run", key.Path()}, {"'forces.gravity' cannot be set while the scene runs"}));
  const ChangedScene fluid("[-0.95, -0.95, -0.35, 0.0]", "[-0.95, -0.95, 0.35, 0.0]");
  EXPECT_TRUE(Refuses(2, {"run", fluid.Path()}, {fluid.Path(), "reaches behind a wall"}));
}

TEST(Scene, ByPathRunsAsByName) {
  const std::string path = std::string(SPHLAB_SOURCE_DIR) + "/assets/scenes/dam-break.toml";
  const Outcome by_name = RunProgram({"info", "dam-break", "--json"});
  EXPECT_EQ(by_name.exit_code, 0);
  EXPECT_EQ(RunProgram({"info", path, "--json"}).out, by_name.out);
}

}  // namespace
}  // namespace sph
