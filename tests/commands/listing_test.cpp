// `sphlab scenes` and `sphlab info`: what there is, and what a scene will do.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "commands/program.hpp"
#include "io/scratch.hpp"

namespace sph {
namespace {

using nlohmann::json;

json JsonOf(Program::Arguments arguments) {
  arguments.emplace_back("--json");
  const Outcome outcome = RunProgram(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(json::accept(outcome.out)) << outcome.out;
  return json::parse(outcome.out, nullptr, false);
}

TEST(Scenes, AreTheFilesInAssets) {
  std::set<std::string> files, listed;
  for (const auto& entry : std::filesystem::directory_iterator(SPHLAB_SOURCE_DIR "/assets/scenes")) {
    files.insert(entry.path().stem());
  }
  for (const json& scene : JsonOf({"scenes"})) {
    listed.insert(scene.at("name").get<std::string>());
    EXPECT_FALSE(scene.at("title").get<std::string>().empty());
    EXPECT_FALSE(scene.at("solver").get<std::string>().empty());
    EXPECT_GT(scene.at("particles").get<long>(), 0);
  }
  EXPECT_EQ(listed, files);
  for (const char* name : {"toy-star", "dam-break", "mueller", "mueller-published"}) EXPECT_TRUE(listed.contains(name));
}

TEST(Scenes, AreListedOneALine) {
  const std::string text = RunProgram({"scenes"}).out;
  const json scenes = JsonOf({"scenes"});
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), scenes.size());
  for (const json& scene : scenes) {
    const auto line = text.find(scene["name"].get<std::string>() + " ");
    ASSERT_NE(line, std::string::npos);
    EXPECT_LT(text.find(scene["title"].get<std::string>(), line), text.find('\n', line));
  }
}

TEST(Scenes, OfAnotherFolderAreFoundThere) {
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch.Path() / "scenes");
  std::filesystem::copy(SPHLAB_SOURCE_DIR "/assets/scenes/toy-star.toml", scratch.Path() / "scenes/star.toml");
  EXPECT_TRUE(RunProgram({"scenes"}, {{{"SPHLAB_ASSETS", scratch.Path()}}}).out.starts_with("star "));
}

TEST(Info, NamesProgramThreadsInstructionSetsAndBackEnds) {
  const json info = JsonOf({"info"});
  EXPECT_EQ(info.at("program"), "sphlab");
  EXPECT_FALSE(info.at("version").get<std::string>().empty());
  EXPECT_GE(info.at("threads").get<int>(), 1);
  EXPECT_TRUE(info.at("instruction_sets").is_array());
  ASSERT_EQ(info.at("gl_back_ends").size(), 2u);
  for (const json& back_end : info["gl_back_ends"]) {
    EXPECT_TRUE(back_end.at("available").get<bool>()) << back_end;
    EXPECT_FALSE(back_end.at("description").get<std::string>().empty());
  }
  const std::string text = RunProgram({"info"}).out;
  for (const char* part : {"sphlab ", "threads: ", "instruction sets: ", "GL back-end osmesa: ", "GL back-end egl: "}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST(InfoOfAScene, IsItsPlanWithAReasonForEveryPass) {
  for (const char* scene : {"dam-break", "toy-star", "mueller", "mueller-published"}) {
    const json info = JsonOf({"info", scene});
    const std::string text = RunProgram({"info", scene}).out;
    EXPECT_EQ(info.at("name"), scene);
    std::set<bool> kinds;
    for (const json& pass : info.at("plan")) {
      kinds.insert(pass.at("runs").get<bool>());
      EXPECT_FALSE(pass.at("reason").get<std::string>().empty()) << pass;
      EXPECT_NE(text.find(pass.at("pass").get<std::string>()), std::string::npos) << pass;
    }
    EXPECT_EQ(kinds, (std::set<bool>{false, true})) << "some passes run, and some are skipped: drawing at least";
  }
}

TEST(InfoOfAScene, FollowsItsSettings) {
  const auto runs = [](const Program::Arguments& arguments, const std::string& name) {
    const json info = JsonOf(arguments);
    for (const json& pass : info["plan"]) {
      if (pass["pass"] == name) return pass["runs"].get<bool>();
    }
    ADD_FAILURE() << "no pass " << name;
    return false;
  };
  EXPECT_TRUE(runs({"info", "dam-break"}, "motion damping"));
  EXPECT_FALSE(runs({"info", "dam-break", "--set", "forces.damping=0"}, "motion damping"));
}

TEST(InfoOfAScene, ShowsWhatMoreParticlesChange) {
  const json few = JsonOf({"info", "dam-break"});
  const json many = JsonOf({"info", "dam-break", "--particles", "2400"});  // four times as many
  const auto ratio = [&](const char* field) { return many[field].get<double>() / few[field].get<double>(); };
  EXPECT_DOUBLE_EQ(ratio("particle_mass"), 0.25);
  EXPECT_DOUBLE_EQ(ratio("spacing"), 0.5);
  EXPECT_DOUBLE_EQ(ratio("support_radius"), 0.5);
  EXPECT_DOUBLE_EQ(ratio("time_step"), 0.5);
  EXPECT_DOUBLE_EQ(ratio("wall_stiffness"), 4);
  EXPECT_DOUBLE_EQ(ratio("wall_damping"), 2);
  const json published = JsonOf({"info", "dam-break", "--particles", "2400", "--set", "walls.scaling=published"});
  EXPECT_EQ(published["wall_stiffness"], few["wall_stiffness"]);
  EXPECT_EQ(published["wall_damping"], few["wall_damping"]);
}

}  // namespace
}  // namespace sph
