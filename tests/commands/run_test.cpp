// `sphlab run`: its one JSON object, its exit codes, and what it does not load.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>

#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

using nlohmann::json;

/// The JSON object of a run; it must be all that is on stdout.
json JsonOf(Program::Arguments arguments, const Surroundings& surroundings = {}) {
  arguments.insert(arguments.begin(), "run");
  arguments.emplace_back("--json");
  const Outcome outcome = RunProgram(arguments, surroundings);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(json::accept(outcome.out)) << outcome.out;
  return json::parse(outcome.out, nullptr, false);
}

bool IsCount(const json& value) { return value.is_number_unsigned(); }
bool IsNumber(const json& value) { return value.is_number(); }
bool IsText(const json& value) { return value.is_string() && !value.get<std::string>().empty(); }
bool AreNumbers(const json& value, std::size_t count) {
  return value.is_array() && value.size() == count && std::all_of(value.begin(), value.end(), IsNumber);
}
bool IsPair(const json& value) { return AreNumbers(value, 2); }
bool IsBox(const json& value) { return AreNumbers(value, 4); }
bool AreTexts(const json& value) { return value.is_array() && std::all_of(value.begin(), value.end(), IsText); }
bool AreNamedNumbers(const json& value) {
  return value.is_object() && std::all_of(value.begin(), value.end(), IsNumber);
}
bool IsRange(const json& value) {
  return AreNamedNumbers(value) && value.size() == 3 && value.at("min") <= value.at("mean") &&
         value.at("mean") <= value.at("max");
}
bool IsHash(const json& value) {
  return value.is_string() && std::regex_match(value.get<std::string>(), std::regex("[0-9a-f]{16}"));
}

const std::vector<std::pair<const char*, bool (*)(const json&)>> kFields = {
    {"scene", IsText},
    {"solver", IsText},
    {"kernel", IsText},
    {"precision", IsText},
    {"simd", IsText},
    {"threads", IsCount},
    {"seed", IsCount},
    {"particles", IsCount},
    {"steps", IsNumber},
    {"time", IsNumber},
    {"dt_last", IsNumber},
    {"wall_seconds", IsNumber},
    {"particle_steps_per_second", IsNumber},
    {"neighbours_mean", IsNumber},
    {"phases", AreNamedNumbers},
    {"skipped", AreTexts},
    {"kinetic_energy", IsNumber},
    {"potential_energy", IsNumber},
    {"internal_energy", IsNumber},
    {"momentum", IsPair},
    {"angular_momentum", IsNumber},
    {"centre_of_mass", IsPair},
    {"max_speed", IsNumber},
    {"density", IsRange},
    {"bounds", IsBox},
    {"outside", IsCount},
    {"deepest", IsNumber},
    {"status", IsText},
    {"state_hash", IsHash},
    {"errors", AreNamedNumbers},
    {"memory_bytes", IsCount},
};

TEST(RunJson, HasEveryFieldWithItsType) {
  for (const char* scene : {"dam-break", "toy-star", "mueller", "mueller-published"}) {
    const json report = JsonOf({scene, "--steps", "5"});
    for (const auto& [name, has_its_type] : kFields) {
      ASSERT_TRUE(report.contains(name)) << name;
      if (std::string_view(name) == "threads" || std::string_view(name) == "outside") {
        EXPECT_GE(report[name].get<long>(), 0) << name;
      } else {
        EXPECT_TRUE(has_its_type(report[name])) << name << ": " << report[name];
      }
    }
    EXPECT_EQ(report["scene"], scene);
    EXPECT_EQ(report["status"], "ok");
  }
}

TEST(RunJson, SaysWhatWasRun) {
  const json report = JsonOf({"dam-break", "--steps", "12", "--threads", "1", "--seed", "7"});
  EXPECT_EQ(report["solver"], "paper");
  EXPECT_EQ(report["steps"], 12);
  EXPECT_EQ(report["particles"], 600);
  EXPECT_EQ(report["seed"], 7);
  EXPECT_EQ(report["threads"], 1);
  EXPECT_NEAR(report["time"].get<double>(), 12 * 0.004, 1e-12);
  EXPECT_EQ(report["dt_last"], 0.004);
  EXPECT_TRUE(report["errors"].empty()) << "the dam break has no exact solution";
}

TEST(RunJson, SaysInWhichPrecisionAndOnWhichInstructionSet) {
  const json in_float = JsonOf({"--steps", "3", "--precision", "float"}, {{{"SPHLAB_SIMD", "baseline"}}});
  EXPECT_EQ(in_float["precision"], "float");
  EXPECT_EQ(in_float["simd"], "baseline");
  const json in_double = JsonOf({"--steps", "3", "--precision", "double"});
  EXPECT_EQ(in_double["precision"], "double");
  EXPECT_NE(in_double["state_hash"], in_float["state_hash"]);
  const double energy = in_double["kinetic_energy"];
  EXPECT_NEAR(in_float["kinetic_energy"].get<double>(), energy, 1e-4 * energy) << "a float has seven digits";
}

TEST(RunJson, HasTheErrorsThatTheScenesReferenceDeclares) {
  const json errors = JsonOf({"toy-star", "--steps", "1"})["errors"];
  EXPECT_GT(errors.at("density_mse").get<double>(), 0);
  EXPECT_GT(errors.at("density_rms_relative").get<double>(), 0);
}

TEST(RunJson, OfMoreParticlesIsTheSameFluid) {
  const json few = JsonOf({"dam-break", "--steps", "0"});
  const json many = JsonOf({"dam-break", "--steps", "0", "--particles", "2400"});
  EXPECT_EQ(many["particles"], 2400);
  EXPECT_EQ(many["dt_last"], 0.002);
  // The same mass at the same height, but for the random start: the mean of N uniform heights is known to 1/sqrt(N).
  EXPECT_NEAR(many["potential_energy"].get<double>() / few["potential_energy"].get<double>(), 1, 0.1);
}

TEST(Run, EndsWhereItIsTold) {
  EXPECT_NEAR(JsonOf({"dam-break", "--until", "0.1"})["time"].get<double>(), 0.1, 1e-9);
  EXPECT_EQ(JsonOf({"dam-break", "--steps", "0"})["steps"], 0);
  EXPECT_NEAR(JsonOf({"mueller-published", "--until", "0.01"})["time"].get<double>(), 0.0105, 1e-9) << "15 whole steps";
}

TEST(Run, PressesKeysAtTheirTimes) {
  const json dropped = JsonOf({"dam-break", "--keys", "0.02:space,0.6:space", "--until", "0.7"});
  EXPECT_EQ(dropped["particles"], 600 + 2 * 150);
  const json not_yet = JsonOf({"dam-break", "--keys", "0.02:space,0.6:space", "--until", "0.5"});
  EXPECT_EQ(not_yet["particles"], 600 + 150);
  const json broken = JsonOf({"dam-break", "--keys", "0.1:d", "--until", "0.5"});
  EXPECT_GT(broken["bounds"][2].get<double>(), -0.3) << "past the dam";
  const json pushed = JsonOf({"dam-break", "--keys", "0:Left:1", "--until", "0.2"});
  EXPECT_LT(pushed["bounds"][2].get<double>(), -0.4) << "0.2 s at 0.5 m/s from -0.35 m";
  const json paused = JsonOf({"dam-break", "--keys", "0.1:p", "--until", "1"});
  EXPECT_NEAR(paused["time"].get<double>(), 0.1, 1e-9) << "nothing wakes it up";
  EXPECT_NEAR(JsonOf({"dam-break", "--keys", "0.1:q", "--until", "1"})["time"].get<double>(), 0.1, 1e-9);
}

TEST(Run, SaysWhatKeysDidOnStderrOnly) {
  const Outcome outcome = RunProgram({"run", "--keys", "0.02:d,0.03:s", "--steps", "10", "--json"});
  EXPECT_TRUE(json::accept(outcome.out)) << outcome.out;
  EXPECT_NE(outcome.err.find("t = 0.02 s: break the dam"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("use `sphlab render`"), std::string::npos) << outcome.err;
}

TEST(Run, QuietlySaysNothing) {
  const Outcome outcome = RunProgram({"run", "--keys", "0.02:d", "--steps", "10", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST(Run, QuietlyAndInJsonIsJsonAlone) {
  const Outcome outcome = RunProgram({"run", "--keys", "0.02:d", "--steps", "10", "--quiet", "--json"});
  EXPECT_TRUE(json::accept(outcome.out)) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST(Run, SaysHowManyParticlesThereAreInPlaceOfThoseAskedFor) {
  const Program::Arguments column = {"run", "water-column", "--steps", "0", "--json"};
  const Outcome outcome = RunProgram(column);
  EXPECT_NE(outcome.err.find("placed 10011 particles (71 x 141) of 10000 asked for"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("fill the box exactly: 9800, 10082"), std::string::npos) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out).at("particles"), 10011);
  EXPECT_EQ(RunProgram({"run", "water-column", "--particles", "9800", "--steps", "0"}).err, "");
}

TEST(Run, WarnsOnceOfEnergyThatNothingPutIn) {
  const auto warnings = [](const Program::Arguments& arguments) {
    const std::string said = RunProgram(arguments).err;
    const std::string warning = "the energy of the fluid has grown";
    const auto place = said.find(warning);
    if (place == std::string::npos) return 0;
    return said.find(warning, place + 1) == std::string::npos ? 1 : 2;
  };
  EXPECT_EQ(warnings({"run", "mueller", "--set", "forces.viscosity=0", "--until", "1"}), 1);
  EXPECT_EQ(warnings({"run", "mueller", "--until", "1"}), 0);
  // Walls that are pushed and blocks that are dropped put energy in.
  EXPECT_EQ(warnings({"run", "dam-break", "--until", "2", "--keys", "0.2:d,0.8:Left:0.8"}), 0);
  EXPECT_EQ(warnings({"run", "mueller", "--until", "2", "--keys", "0.1:space,0.5:space,1:space"}), 0);
  EXPECT_EQ(warnings({"run", "mueller", "--set", "forces.viscosity=0", "--until", "1", "--quiet"}), 0);
}

TEST(Run, GivesTheSameBitsWithAnyNumberOfThreads) {
  for (const char* scene : {"dam-break", "toy-star", "mueller"}) {
    const json one = JsonOf({scene, "--steps", "60", "--threads", "1"});
    for (const char* threads : {"2", "3"}) {
      const json more = JsonOf({scene, "--steps", "60", "--threads", threads});
      EXPECT_EQ(one["state_hash"], more["state_hash"]) << scene << ", threads " << threads;
      EXPECT_EQ(one["kinetic_energy"], more["kinetic_energy"]);
    }
  }
}

TEST(Run, FollowsItsSeed) {
  const json first = JsonOf({"dam-break", "--steps", "5", "--seed", "1"})["state_hash"];
  EXPECT_EQ(first, JsonOf({"dam-break", "--steps", "5", "--seed", "1"})["state_hash"]);
  EXPECT_EQ(first, JsonOf({"dam-break", "--steps", "5"})["state_hash"]) << "seed 1 is the scene's";
  EXPECT_NE(first, JsonOf({"dam-break", "--steps", "5", "--seed", "2"})["state_hash"]);
}

TEST(Run, OfAnUnstableSceneSaysStepParticleAndNumbersAndExitsWithThree) {
  const Outcome outcome =
      RunProgram({"run", "dam-break", "--set", "method.time_step=0.05", "--set", "method.retries=0", "--json"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(json::parse(outcome.out)["status"], "unstable");
  const std::regex message(
      "sphlab: unstable: step \\d+, t = [0-9.e+-]+ s: particle \\d+ at \\(.+, .+\\) m with velocity \\(.+\\) m/s: "
      ".+\n");
  EXPECT_TRUE(std::regex_match(outcome.err, message)) << outcome.err;
  EXPECT_NE(outcome.err.find("0.05 s"), std::string::npos) << "the step itself: " << outcome.err;
}

TEST(Run, OfAnUnstableSceneLeavesItsRows) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.Path() / "run.csv";
  EXPECT_EQ(RunProgram({"run", "--set", "method.time_step=0.05", "--set", "method.retries=0", "--csv", file}).exit_code,
            3);
  EXPECT_TRUE(Contents(file).starts_with("time [s],"));
  EXPECT_TRUE(Contents(file).ends_with("\n"));
}

/// The file names of the shared libraries that the program loaded.
std::string LibrariesOf(const Program::Arguments& arguments) {
  const ScratchDirectory scratch;
  const std::string log = scratch.Path() / "libraries";
  EXPECT_EQ(RunProgram(arguments, {{{"LD_DEBUG", "files"}, {"LD_DEBUG_OUTPUT", log}}}).exit_code, 0);
  std::string text;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.Path())) {
    if (entry.path().filename().string().starts_with("libraries")) text += Contents(entry.path());
  }
  return text;
}

TEST(Run, LoadsNoGlAndNoWindow) {
  const std::regex screen("lib(GL|GLX|GLESv2|EGL|OSMesa|glapi|glut|gbm)[.-][^ ;]*");
  const ScratchDirectory scratch;
  const std::string when_drawing = LibrariesOf({"render", "--out", scratch.Path(), "--frames", "1", "--threads", "1"});
  if (when_drawing.empty()) GTEST_SKIP() << "the dynamic loader here keeps no log";
  EXPECT_TRUE(std::regex_search(when_drawing, screen)) << "the log would not show it";
  const std::string when_running = LibrariesOf({"run", "--steps", "5"});
  EXPECT_NE(when_running.find("libc.so"), std::string::npos);
  std::smatch found;
  EXPECT_FALSE(std::regex_search(when_running, found, screen)) << found.str();
}

/// Water behind a dam that comes for a tenth of a second, in front of a wall that it covers.
std::string CoveredWall(const std::string& first, const std::string& second) {
  return R"(title = "covered wall"
solver = "delta"
until = 0.2
fluid = { particles = 400, mass = 0.625, region = { box = [0.0, 0.0, 0.5, 0.5] }, arrange = "lattice", flow = "hydrostatic" }
equation_of_state.ideal_gas = { k = 500.0, rho0 = 1000.0 }
method = { kernel = "wendland-c2", smoothing_length = 0.05, time_step = 0.0005, step = "adaptive" }
forces.gravity = [0.0, -9.81]
walls.kind = "mirror"
arrows = { wall = "dam", speed = 1.0 }
wall = [ { name = "left", at = 0.0, fluid = "right" }, )" +
         first + ", " + second + R"(, { name = "floor", at = 0.0, fluid = "above" } ])";
}

TEST(Run, DoesNotDependOnTheOrderOfTheWallsOnOneSide) {
  const std::string dam = R"({ name = "dam", at = 0.5, fluid = "left", range = [0.2, 0.9] })";
  const std::string outer = R"({ name = "outer", at = 1.0, fluid = "left" })";
  const ScratchDirectory scratch;
  const std::string file = scratch.Path() / "walls.toml";
  const auto hash = [&](const std::string& text) {
    std::ofstream(file) << text;
    return JsonOf({file, "--threads", "1", "--keys", "0.02:Left:0.1"})["state_hash"];
  };
  EXPECT_EQ(hash(CoveredWall(dam, outer)), hash(CoveredWall(outer, dam)));
}

TEST(Run, WarnsOfOldNamesInASceneOnStderr) {
  const Outcome outcome = RunProgram({"run", "couette", "--steps", "1", "--json", "--set", "walls.slip=none"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "sphlab: --set: walls.slip = 'none' is the old name of 'no-slip'\n");
  EXPECT_TRUE(json::accept(outcome.out));
}

TEST(Run, WritesPointsInALocaleWithCommas) {
  const ScratchDirectory scratch;
  const std::string make =
      "localedef -i de_DE -f UTF-8 '" + (scratch.Path() / "de_DE.UTF-8").string() + "' 2>/dev/null";
  if (std::system(make.c_str()) != 0) GTEST_SKIP() << "no German locale to be had here";
  const Surroundings german{{{"LOCPATH", scratch.Path()}, {"LC_ALL", "de_DE.UTF-8"}}};
  const std::filesystem::path file = scratch.Path() / "run.csv";
  const Program::Arguments arguments = {"dam-break", "--until", "0.02", "--set", "forces.damping=7.5", "--csv", file};
  const json report = JsonOf(arguments, german);
  const std::string rows = Contents(file);
  EXPECT_NEAR(report["time"].get<double>(), 0.02, 1e-9);
  EXPECT_EQ(report["state_hash"], JsonOf(arguments)["state_hash"]);
  EXPECT_EQ(rows, Contents(file));
}

}  // namespace
}  // namespace sph
