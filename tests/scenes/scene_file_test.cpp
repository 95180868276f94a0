// A wrong scene file is refused with its place, what is accepted, and the nearest name.
#include "scenes/scene_file.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scenes/scene_text.hpp"

namespace sph {
namespace {

struct Wrong {
  std::string from, to;
  std::vector<std::string> message;  ///< parts of it
};

/// Every change of kScene is refused, with these parts in the message.
void ExpectRefusals(const std::vector<Wrong>& all) {
  for (const Wrong& wrong : all) EXPECT_TRUE(Has(Refusal(Changed(wrong.from, wrong.to)), wrong.message)) << wrong.to;
}

TEST(ReadScene, TakesTheTestsOwnScene) {
  const Scene scene = SceneFrom(kScene);
  EXPECT_EQ(scene.title, "Test");
  EXPECT_EQ(scene.name.substr(0, 7), "sphlab-");
  EXPECT_EQ(scene.base.fluid.particles, 100u);
  EXPECT_EQ(scene.base.fluid.region.box, (Box{0, 0, 1, 1}));
  ASSERT_EQ(scene.base.walls.size(), 1u);
  EXPECT_EQ(scene.base.walls[0].at, -0.1);
  EXPECT_EQ(scene.base.walls[0].lowest, -0.5);
  EXPECT_EQ(scene.base.walls[0].highest, 0.5);
}

TEST(ReadScene, RefusesUnknownKeysWithPlaceAndNearestName) {
  ExpectRefusals({
      {"particles = 100", "particels = 100", {"FILE:3:", "fluid.particels", "Did you mean 'fluid.particles'?"}},
      {"smoothing_length", "smoothing", {"FILE:9:", "unknown key 'method.smoothing'"}},
      {"k = 0.5", "kk = 0.5", {"FILE:7:", "'equation_of_state.tait.kk'", "Did you mean 'equation_of_state.tait.k'?"}},
      {"title", "titel", {"FILE:1:", "Did you mean 'title'?"}},
      {"at = -0.1", "att = -0.1", {"FILE:13:", "wall.att", "Did you mean 'at'?"}},
  });
}

TEST(ReadScene, RefusesUnknownTablesWithTheNearestName) {
  ExpectRefusals({
      {"[fluid]", "[fluids]", {"unknown key 'fluids'", "Did you mean 'fluid'?"}},
      {"[[wall]]", "[[wal]]", {"unknown key 'wal'", "Did you mean 'wall'?"}},
      {"tait = {", "tail = {", {"'equation_of_state.tail'", "Did you mean 'equation_of_state.tait'?"}},
      {"[method]", "[forcess]\ndamping = 1\n[method]", {"unknown key 'forcess'", "Did you mean 'forces'?"}},
  });
}

TEST(ReadScene, RefusesWrongTypesWithPlaceAndWhatIsAccepted) {
  ExpectRefusals({
      {"0.001", "\"fast\"", {"FILE:10:13: method.time_step = 'fast'", "a finite number > 0"}},
      {"\"Test\"", "7", {"FILE:1:9: title = 7", "a text in quotes"}},
      {"100", "100.0", {"FILE:3:13: fluid.particles = 100.0", "a whole number from 1 to 100000000"}},
      {"[0.0, 0.0, 1.0, 1.0]", "[0.0, 0.0, 1.0]", {"FILE:5:18", "four finite numbers"}},
      {"[0.0, 0.0, 1.0, 1.0]", "[0.0, 0.0, \"1\", 1.0]", {"FILE:5:18", "four finite numbers"}},
      {"tait = { k = 0.5, rho0 = 1.0 }", "tait = 5", {"FILE:7:8", "equation_of_state.tait takes keys of its own"}},
      {"[[wall]]", "[wall]", {"FILE:11:", "[[wall]]"}},
      {"\"floor\"", "true", {"FILE:12:8: wall.name = true", "a text in quotes"}},
  });
}

TEST(ReadScene, RefusesImpossibleValuesWithWhatIsAccepted) {
  ExpectRefusals({
      {"0.001", "-0.001", {"FILE:10:13: method.time_step = -0.001", "> 0"}},
      {"0.001", "0", {"FILE:10:13", "> 0"}},
      {"0.001", "nan", {"FILE:10:13: method.time_step = nan", "a finite number"}},
      {"0.001", "inf", {"FILE:10:13", "a finite number"}},
      {"mass = 0.01", "mass = -1", {"FILE:4:8", "> 0"}},
      {"100", "0", {"FILE:3:13: fluid.particles = 0", "from 1"}},
      {"100", "-5", {"FILE:3:13: fluid.particles = -5", "from 1"}},
      {"100", "1000000000000", {"FILE:3:13", "to 100000000"}},
      {"[0.0, 0.0, 1.0, 1.0]", "[1.0, 0.0, 0.0, 1.0]", {"FILE:5:18", "x0 < x1"}},
      {"[0.0, 0.0, 1.0, 1.0]", "[0.0, 0.0, nan, 1.0]", {"FILE:5:18", "four finite numbers"}},
      {"[-0.5, 0.5]", "[0.0, 0.5]", {"FILE:15:9", "must contain at = -0.1"}},
  });
}

TEST(ReadScene, RefusesUnknownChoicesWithAllThatThereAre) {
  ExpectRefusals({
      {"[fluid]", "solver = \"peper\"\n[fluid]", {"FILE:2:10", "paper, mueller", "Did you mean 'paper'?"}},
      {"mass", "arrange = \"latice\"\nmass", {"FILE:4:11", "random, lattice, jittered", "Did you mean 'lattice'?"}},
      {"[method]",
       "[method]\nintegration = \"euler\"",
       {"FILE:9:15", "leapfrog, leapfrog-published, symplectic-euler"}},
      {"\"above\"", "\"top\"", {"FILE:14:9", "left, right, below, above"}},
  });
}

TEST(ReadScene, RefusesMissingKeysByName) {
  ExpectRefusals({
      {"title = \"Test\"\n", "", {"FILE: the key 'title' is missing"}},
      {"mass = 0.01\n", "", {"FILE: the key 'fluid.mass' is missing", "kg/m"}},
      {"name = \"floor\"\n", "", {"FILE:11:", "'wall.name' is missing"}},
      {"fluid = \"above\"\n", "", {"FILE:11:", "'wall.fluid' is missing"}},
  });
  EXPECT_TRUE(Has(Refusal(""), {"FILE", "'title' is missing"})) << "an empty file is a scene without keys";
}

TEST(ReadScene, RefusesTwoOfWhatAFluidHasOne) {
  ExpectRefusals({
      {"tait =",
       "polytrope = { k = 0.1 }\ntait =",
       {"FILE:8:", "equation_of_state.tait beside equation_of_state.polytrope"}},
      {"{ box",
       "{ disk = { centre = [0.5, 0.5], radius = 0.5 }, box",
       {"FILE:5:", "fluid.region.disk beside fluid.region.box"}},
      {"[[wall]]",
       "[[wall]]\nname = \"floor\"\nat = -1\nfluid = \"above\"\n[[wall]]",
       {"FILE:15:", "two walls named 'floor'"}},
  });
}

/// The scene with mirrors, and the floor as these lines say.
std::string WithFloor(const std::string& lines) {
  return Changed("range = [-0.5, 0.5]\n", lines + "\n[walls]\nkind = \"mirror\"\n");
}

TEST(ReadScene, TakesTheVelocityOfAWallAlongItselfAsANumberOrAsAnOscillation) {
  const auto velocity = [](const std::string& value) {
    const Scene scene = SceneFrom(WithFloor("slip = \"no-slip\"\ntangential_velocity = " + value), {"solver=delta"});
    return scene.base.walls[0].tangential;
  };
  EXPECT_EQ(velocity("-1.5").At(7), -1.5);
  EXPECT_EQ(velocity("{ mean = 2 }").At(7), 2);
  const TangentialVelocity swings = velocity("{ mean = 1, amplitude = 2, frequency = 3, phase = 4 }");
  EXPECT_EQ(swings.mean, 1);
  EXPECT_EQ(swings.amplitude, 2);
  EXPECT_EQ(swings.frequency, 3);
  EXPECT_EQ(swings.phase, 4);
}

TEST(ReadScene, RefusesAnOscillationThatIsNone) {
  const auto refusal = [](const std::string& value) {
    return Refusal(WithFloor("tangential_velocity = " + value), {"solver=delta"});
  };
  EXPECT_TRUE(Has(refusal("\"fast\""), {"FILE:15:", "wall.tangential_velocity takes a number [m/s] or { mean,"}));
  EXPECT_TRUE(Has(refusal("{ means = 1 }"), {"FILE:15:", "wall.tangential_velocity.means", "Did you mean 'mean'?"}));
  EXPECT_TRUE(Has(refusal("{ amplitude = 1 }"), {"FILE:15:", "amplitude [m/s] and frequency [Hz] together"}));
  EXPECT_TRUE(Has(refusal("{ mean = 1, phase = 1 }"), {"FILE:15:", "phase [rad] only with them"}));
  EXPECT_TRUE(Has(refusal("{ amplitude = 1, frequency = 0 }"), {"FILE:15:", "frequency = 0", "> 0"}));
}

TEST(ReadScene, WarnsOfOldNamesAndTakesThem) {
  const Scene scene = SceneFrom(WithFloor("slide = 2") + "slip = \"none\"\n", {"solver=delta"});
  EXPECT_TRUE(Sticks(scene.base.walls[0], scene.base.wall));
  EXPECT_EQ(scene.base.walls[0].tangential.mean, 2);
  ASSERT_EQ(scene.warnings.size(), 2u);
  const std::string both = scene.warnings[0] + "\n" + scene.warnings[1];
  EXPECT_TRUE(Has(both, {":15:9: wall.slide is the old name of wall.tangential_velocity",
                         ":18:8: walls.slip = 'none' is the old name of 'no-slip'"}));
  EXPECT_FALSE(SceneFrom(WithFloor("slip = \"free\""), {"solver=delta", "walls.slip=no-slip"}).warnings.empty());
  EXPECT_TRUE(SceneFrom(kScene, {}).warnings.empty());
  EXPECT_TRUE(Has(Refusal(WithFloor("slide = 2\ntangential_velocity = 2")),
                  {"FILE:15:9: wall.slide is the old name of wall.tangential_velocity, which is there, too"}));
  EXPECT_TRUE(Has(Refusal(kScene, {"walls.slip=non"}), {"one of: free-slip, no-slip"}));
  EXPECT_TRUE(Has(Refusal(WithFloor("slid = 2")), {"unknown key 'wall.slid'"}));
}

TEST(ReadScene, RefusesBrokenTomlWithLineAndColumn) {
  ExpectRefusals({
      {"particles = 100", "particles = ", {"FILE:3:"}},
      {"[fluid]", "[fluid", {"FILE:2:"}},
      {"mass = 0.01", "mass = 0.01\nmass = 0.02", {"FILE:5:"}},
      {"\"Test\"", "\"Test", {"FILE:1:"}},
  });
  EXPECT_NE(Refusal(std::string("title = \"\xff\xfe\"\n")), "accepted") << "not UTF-8";
  EXPECT_NE(Refusal(std::string(100, '\0')), "accepted");
}

TEST(ReadScene, TakesWindowsLineEnds) {
  std::string text;
  for (const char c : kScene) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(SceneFrom(text).title, "Test");
}

TEST(ReadScene, AnUnreadablePathIsTroubleNotUsage) {
  const auto refusal = [](const std::filesystem::path& path) -> std::string {
    try {
      ReadScene(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.Code(), ExitCode::kTrouble) << error.what();
      return error.what();
    }
    return "accepted";
  };
  EXPECT_TRUE(Has(refusal("/no/such/scene.toml"), {"cannot read", "/no/such/scene.toml", "No such file"}));
  EXPECT_TRUE(Has(refusal(::testing::TempDir()), {"cannot read", "it is a directory"}));
  EXPECT_TRUE(Has(refusal(std::string(5000, 'x') + ".toml"), {"cannot read", "too long"}));
  const TextFile file(kScene);
  EXPECT_TRUE(Has(refusal(file.Path() / "inside.toml"), {"cannot read", "Not a directory"}));
}

TEST(ReadScene, ReadsControlsInTheirOrderAndRefusesWrongOnes) {
  const std::string control = R"([[key]]
press = "d"
what = "opens"
do = [ { move_wall = "floor", to = -0.3 }, { set = "forces.damping", to = 1 } ]
)";
  const Scene scene = SceneFrom(kScene + control);
  ASSERT_EQ(scene.controls.size(), 1u);
  EXPECT_EQ(scene.controls[0].press, "d");
  ASSERT_EQ(scene.controls[0].actions.size(), 2u);
  EXPECT_EQ(std::get<MoveWallAction>(scene.controls[0].actions[0]).to, -0.3);
  EXPECT_EQ(std::get<SetAction>(scene.controls[0].actions[1]).key, "forces.damping");
  const auto with = [&](const std::string& actions) {
    return Refusal(kScene + "[[key]]\npress = \"d\"\ndo = " + actions + "\n");
  };
  EXPECT_TRUE(Has(with("[ { move = \"floor\", to = 1 } ]"), {"FILE:18:", "key.do takes { move_wall"}));
  EXPECT_TRUE(
      Has(with("[ { move_wall = \"floor\", to = \"far\" } ]"), {"FILE:18:36: key.do.to = 'far'", "a finite number"}));
  EXPECT_TRUE(Has(with("[ { move_wall = 3, to = 1 } ]"), {"FILE:18:", "key.do.move_wall = 3"}));
  EXPECT_TRUE(Has(with("[]"), {"FILE:18:", "a list of actions"}));
  EXPECT_TRUE(Has(with("3"), {"FILE:18:", "a list of actions"}));
  EXPECT_TRUE(Has(Refusal(kScene + "[[key]]\npress = \"d\"\n"), {"FILE:16:", "'key.do' is missing"}));
}

}  // namespace
}  // namespace sph
