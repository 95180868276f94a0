// README.md says what is true: its keys, scenes, commands, options, fields, pictures, tests and functions exist.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "commands/program.hpp"
#include "io/scratch.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/scene_file.hpp"
#include "window/controls.hpp"

namespace sph {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = SPHLAB_SOURCE_DIR;

std::string Readme() { return Contents(kRoot / "README.md"); }

/// The rows of the table below a heading: its cells without the blanks around them.
std::vector<std::vector<std::string>> Table(const std::string& heading) {
  const std::string text = Readme();
  const std::size_t begin = text.find("\n## " + heading + "\n");
  EXPECT_NE(begin, std::string::npos) << heading;
  std::istringstream section(text.substr(begin + 1, text.find("\n## ", begin + 1) - begin));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(section, line);) {
    if (!line.starts_with("| ")) continue;
    rows.emplace_back();
    static const std::regex cell(R"(\| (.+?) (?=\|))");
    for (std::sregex_iterator it(line.begin(), line.end(), cell), end; it != end; ++it) rows.back().push_back((*it)[1]);
  }
  if (rows.size() < 3) {
    ADD_FAILURE() << "no table below " << heading;
    return {};
  }
  rows.erase(rows.begin(), rows.begin() + 2);  // its head
  return rows;
}

std::vector<std::string> Quoted(const std::string& text) {
  static const std::regex quoted("`([^`]+)`");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), quoted), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

/// Everything in the C++ files of a folder.
std::string Sources(const char* folder) {
  std::string text;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const fs::path ending = entry.path().extension();
    if (ending == ".cpp" || ending == ".hpp") text += Contents(entry.path());
  }
  return text;
}

bool HasWord(const std::string& text, const std::string& word) {
  const auto in_word = [&](std::size_t at) { return at < text.size() && (std::isalnum(text[at]) || text[at] == '_'); };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if (!in_word(at - 1) && !in_word(at + word.size())) return true;
  }
  return false;
}

/// "Suite.Name" of every test in C++ text.
std::set<std::string> TestsIn(const std::string& text) {
  static const std::regex test("TEST\\w*\\((\\w+),\\s*(\\w+)\\)");
  std::set<std::string> names;
  for (std::size_t at = text.find("TEST"); at != std::string::npos; at = text.find("TEST", at + 1)) {
    std::smatch parts;
    // From each "TEST" on: a search through all of the text takes a minute where checks are compiled in.
    if (std::regex_search(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), parts, test,
                          std::regex_constants::match_continuous)) {
      names.insert(parts[1].str() + "." + parts[2].str());
    }
  }
  return names;
}

TEST(Readme, HasTheTableOfControls) {
  const auto rows = Table("Keys");
  ASSERT_EQ(rows.size(), AllControls().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][0], "`" + AllControls()[i].shown + "`");
    EXPECT_EQ(rows[i][1], AllControls()[i].does);
  }
}

TEST(Readme, HasEveryScene) {
  const auto rows = Table("Scenes");
  std::vector<std::string> named;
  for (const auto& row : rows) {
    named.push_back(Quoted(row[0]).at(0));
    EXPECT_EQ(row[1], ReadScene(FindScene(named.back())).solver) << named.back();
  }
  EXPECT_EQ(named, SceneNames());
}

TEST(Readme, NamesTestsAndFunctionsThatExist) {
  const std::set<std::string> tests = TestsIn(Sources("tests"));
  const std::string sources = Sources("src");
  for (const auto& row : Table("From equation to test")) {
    ASSERT_EQ(row.size(), 3u) << row[0];
    for (const std::string& name : Quoted(row[1])) {
      const std::string function = name.substr(name.find("::") == std::string::npos ? 0 : name.find("::") + 2);
      EXPECT_TRUE(HasWord(sources, function)) << name;
    }
    EXPECT_FALSE(Quoted(row[2]).empty()) << row[0];
    for (const std::string& name : Quoted(row[2])) EXPECT_TRUE(tests.contains(name)) << name;
  }
}

TEST(Readme, NamesFilesThatExist) {
  const std::string text = Readme();
  static const std::regex path("(?:^|[ (])((?:src|assets|tests|shaders)/[A-Za-z0-9_./-]*[A-Za-z0-9])");
  for (std::sregex_iterator it(text.begin(), text.end(), path), end; it != end; ++it) {
    EXPECT_TRUE(fs::exists(kRoot / (*it)[1].str())) << (*it)[1];
  }
  EXPECT_TRUE(fs::exists(kRoot / "LICENSE"));
}

TEST(Readme, NamesEveryFieldOfTheReport) {
  const std::string text = Readme();
  const auto report = nlohmann::json::parse(RunProgram({"run", "--steps", "1", "--json"}).out);
  for (const auto& [field, value] : report.items()) {
    EXPECT_NE(text.find("`" + field + "`"), std::string::npos) << field;
  }
}

TEST(Readme, NamesEveryCommandAndOption) {
  const std::string text = Readme();
  for (const char* command : {"", "render", "run", "scenes", "info", "figures", "verify", "bench", "stress"}) {
    EXPECT_NE(text.find(fmt::format("\n    sphlab {}", command)), std::string::npos) << command;
    const std::string help =
        RunProgram(*command == '\0' ? Program::Arguments{"--help"} : Program::Arguments{command, "--help"}).out;
    static const std::regex option("\n  (--[a-z]+)");
    for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it) {
      EXPECT_NE(text.find((*it)[1]), std::string::npos) << (*it)[1];
    }
  }
}

TEST(Readme, SettingsInItsExamplesAreAccepted) {
  const std::string text = Readme();
  static const std::regex setting("--set ([a-z_.-]+=[^ `]+)");
  int count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), setting), end; it != end; ++it, ++count) {
    EXPECT_EQ(RunProgram({"info", "dam-break", "--set", (*it)[1]}).exit_code, 0) << (*it)[1];
  }
  EXPECT_GT(count, 2);
}

}  // namespace
}  // namespace sph
