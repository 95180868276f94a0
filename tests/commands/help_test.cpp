// --help: every command's, with every option that scripts may rely on.
#include "commands/program.hpp"

namespace sph {
namespace {

const std::vector<std::string> kSceneOptions = {"SCENE",       "--set",  "--solver", "--precision",
                                                "--particles", "--seed", "--threads"};

void ExpectHelp(const Program::Arguments& command, const std::vector<std::string>& options) {
  Program::Arguments arguments = command;
  arguments.emplace_back("--help");
  const Outcome outcome = RunProgram(arguments);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const std::string& option : options) {
    EXPECT_NE(outcome.out.find("\n  " + option + " "), std::string::npos) << option << " in:\n" << outcome.out;
  }
  EXPECT_NE(outcome.out.find("Exit codes: 0 done, 1 "), std::string::npos);
}

std::vector<std::string> With(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

TEST(Help, NamesEveryCommand) {
  ExpectHelp({}, With(kSceneOptions, {"render", "run", "scenes", "info", "figures", "bench", "stress"}));
}

TEST(Help, NamesEveryOptionOfACommand) {
  ExpectHelp({"render"}, With(kSceneOptions, {"--out", "--frames", "--fps", "--until", "--size", "--backend", "--keys",
                                              "--json", "--quiet"}));
  ExpectHelp({"run"}, With(kSceneOptions, {"--until", "--steps", "--csv", "--every", "--keys", "--json", "--quiet"}));
  ExpectHelp({"scenes"}, {"--json"});
  ExpectHelp({"info"}, With(kSceneOptions, {"--json"}));
  ExpectHelp({"figures"}, {"--out"});
  ExpectHelp({"bench"}, {"CASE", "--out", "--quick", "--peers", "--longest", "--threads"});
  ExpectHelp({"stress"}, {"TEST", "--out", "--quick", "--count", "--seed", "--threads", "--json"});
}

}  // namespace
}  // namespace sph
