// What the command line refuses, each with exit code 2 and a message that helps, and without having touched anything.
#include <filesystem>

#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

struct Slip {
  std::string name;
  Program::Arguments arguments;
  std::vector<std::string> says;
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.name; }

class WrongCommandLine : public testing::TestWithParam<Slip> {};

TEST_P(WrongCommandLine, IsRefusedWithWhatIsAccepted) {
  EXPECT_TRUE(Refuses(2, GetParam().arguments, GetParam().says));
}

// clang-format off
const std::vector<Slip> kSlips = {
    {"UnknownScene", {"run", "dam-brek"}, {"unknown scene 'dam-brek'", "'dam-break'?", "toy-star", ".toml"}},
    {"UnknownSceneInAWindow", {"dambreak"}, {"unknown scene 'dambreak'", "'dam-break'?"}},
    {"UnknownSceneLikeNoOther", {"info", "whirlpool"}, {"unknown scene 'whirlpool'", "There are: breathing-star, capillary-drop, couette, dam-break, "}},
    {"UnknownCommand", {"rendr"}, {"unknown command or scene 'rendr'", "'render'?"}},
    {"UnknownCommandWithArguments", {"rnu", "dam-break"}, {"unknown command or scene 'rnu'", "'run'?"}},
    {"UnknownOption", {"run", "--partcles", "3"}, {"'--partcles'", "'--particles'?", "`sphlab run --help`"}},
    {"UnknownOptionWithEquals", {"run", "--seeds=3"}, {"'--seeds=3'", "'--seed'?"}},
    {"UnknownOptionOfScenes", {"scenes", "--jsn"}, {"'--jsn'", "'--json'?", "`sphlab scenes --help`"}},
    {"UnknownOptionOfTheWindow", {"--solvr", "paper"}, {"'--solvr'", "'--solver'?"}},
    {"TwoScenes", {"run", "dam-break", "toy-star"}, {"not expected: 'toy-star'"}},
    {"OptionBeforeTheCommand", {"--seed", "3", "run"}, {"--seed stands before the command 'run'"}},
    {"SceneBeforeTheCommand", {"toy-star", "run"}, {"SCENE stands before the command 'run'"}},
    {"NoParticles", {"run", "--particles", "0"}, {"--particles", "'0' is not a whole number from 1 to 100000000"}},
    {"NegativeParticles", {"run", "--particles", "-5"}, {"--particles", "-5"}},
    {"PartsOfParticles", {"run", "--particles", "2.5"}, {"--particles", "'2.5' is not a whole number from 1 to"}},
    {"UnderscoredParticles", {"run", "--particles", "1_000"}, {"--particles", "'1_000' is not a whole number"}},
    {"NoParticlesBySetting", {"run", "--set", "fluid.particles=0"}, {"fluid.particles = 0", "a whole number from 1"}},
    {"NegativeStep", {"run", "--set", "method.time_step=-1"}, {"method.time_step = -1", "a finite number > 0"}},
    {"ZeroStep", {"run", "--set", "method.time_step=0"}, {"method.time_step = 0", "a finite number > 0"}},
    {"StepThatIsNoNumber", {"run", "--set", "method.time_step=nan"}, {"method.time_step = nan", "a finite number > 0"}},
    {"InfiniteStep", {"run", "--set", "method.time_step=inf"}, {"method.time_step = inf", "a finite number > 0"}},
    {"StepInWords", {"run", "--set", "method.time_step=short"}, {"method.time_step = 'short'", "a finite number > 0"}},
    {"UnknownSetting", {"run", "--set", "method.time_stp=1"}, {"unknown key 'method.time_stp'", "'method.time_step'?"}},
    {"SettingWithoutValue", {"run", "--set", "method.time_step"}, {"KEY=VALUE"}},
    {"SettingWithoutKey", {"run", "--set", "=3"}, {"KEY=VALUE"}},
    {"WallThatIsNotThere", {"run", "--set", "wall.damm.at=0"}, {"no wall 'damm'", "'dam'?"}},
    {"WallInTheFluid", {"run", "--set", "wall.dam.at=-0.5"}, {"reaches behind a wall"}},
    {"ChoiceThatIsNone", {"run", "--set", "method.integration=leapfrok"}, {"'leapfrok'", "symplectic-euler", "'leapfrog'?"}},
    {"EndThatIsNoNumber", {"run", "--until", "nan"}, {"--until", "'nan' is not a finite number > 0"}},
    {"EndBeforeTheStart", {"run", "--until", "-1"}, {"--until", "'-1'"}},
    {"InfiniteEnd", {"render", "--until", "inf", "--out", "OUT"}, {"--until", "'inf'"}},
    {"NegativeSteps", {"run", "--steps", "-1"}, {"--steps", "-1"}},
    {"StepsAndAnEnd", {"run", "--steps", "3", "--until", "1"}, {"--until", "--steps"}},
    {"EveryWithoutCsv", {"run", "--every", "0.1"}, {"--every requires --csv"}},
    {"EveryOfZero", {"run", "--csv", "OUT/a.csv", "--every", "0"}, {"--every", "'0'"}},
    {"NegativeSeed", {"run", "--seed", "-1"}, {"--seed", "'-1' is not a whole number"}},
    {"SeedInWords", {"run", "--seed", "one"}, {"--seed", "'one'"}},
    {"NegativeThreads", {"run", "--threads", "-1"}, {"--threads", "-1"}},
    {"UnknownSolver", {"run", "--solver", "papr"}, {"unknown solver 'papr'", "'paper'?", "mueller"}},
    {"UnknownPrecision", {"run", "--precision", "half"}, {"--precision", "half", "float", "double"}},
    {"SolverThatLacksItsScene", {"run", "toy-star", "--solver", ""}, {"--solver"}},
    {"UnknownKey", {"run", "--keys", "4:z"}, {"unknown key 'z' in '4:z'", "Left", "Esc"}},
    {"KeyNearlyRight", {"run", "--keys", "4:spce"}, {"unknown key 'spce'", "'space'?"}},
    {"KeyWithoutTime", {"run", "--keys", "d"}, {"'d'", "T:KEY", "4:d"}},
    {"KeyAtNoTime", {"run", "--keys", "nan:d"}, {"'nan:d'", "T:KEY"}},
    {"KeyBeforeTheStart", {"run", "--keys", "-1:d"}, {"'-1:d'", "T and SECONDS >= 0"}},
    {"KeyHeldForNoTime", {"run", "--keys", "1:d,2:Left:long"}, {"'2:Left:long'", "T:KEY:SECONDS"}},
    {"KeysThatEndWithAComma", {"run", "--keys", "1:d,"}, {"''", "T:KEY"}},
    {"NoFolderForFrames", {"render"}, {"--out is required", "`sphlab render --help`"}},
    {"SizeOfZero", {"render", "--out", "OUT", "--size", "0x100"}, {"--size 0x100", "WIDTHxHEIGHT", "1280x720"}},
    {"SizeOfOneNumber", {"render", "--out", "OUT", "--size", "100"}, {"--size 100", "WIDTHxHEIGHT"}},
    {"SizeWithMore", {"render", "--out", "OUT", "--size", "10x10x10"}, {"--size 10x10x10", "WIDTHxHEIGHT"}},
    {"SizeBeyondAnyPicture", {"render", "--out", "OUT", "--size", "99999x10"}, {"--size 99999x10", "16384"}},
    {"UnknownBackend", {"render", "--out", "OUT", "--backend", "osmessa"}, {"'osmessa'", "auto, osmesa, egl", "'osmesa'?"}},
    {"NoFrames", {"render", "--out", "OUT", "--frames", "0"}, {"--frames", "0"}},
    {"NoFramesPerSecond", {"render", "--out", "OUT", "--fps", "0"}, {"--fps", "'0'"}},
    {"FramesWithoutEnd", {"render", "--out", "OUT", "--fps", "1e30"}, {"--fps 1e+30", "at most"}},
};
// clang-format on

INSTANTIATE_TEST_SUITE_P(Slips, WrongCommandLine, testing::ValuesIn(kSlips),
                         [](const auto& tested) { return tested.param.name; });

TEST(WrongInstructionSet, IsRefusedWithWhatIsAvailable) {
  EXPECT_TRUE(Refuses(2, {"run", "--steps", "1"}, {"SPHLAB_SIMD", "'avx9'", "baseline"}, {{{"SPHLAB_SIMD", "avx9"}}}));
}

TEST(WrongCommandLine, LeavesNoFolderBehind) {
  const ScratchDirectory scratch;
  for (const Slip& slip : kSlips) {
    Program::Arguments arguments = slip.arguments;
    bool writes = false;
    for (std::string& argument : arguments) {
      if (!argument.starts_with("OUT")) continue;
      argument = scratch.Path() / argument;
      writes = true;
    }
    if (!writes) continue;
    EXPECT_EQ(RunProgram(arguments).exit_code, 2) << slip.name;
    EXPECT_EQ(scratch.Count(), 0) << slip.name;
  }
}

}  // namespace
}  // namespace sph
