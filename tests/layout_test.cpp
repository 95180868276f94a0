// Who may include whom in src/, and what a source file there looks like: read from the files, so that it cannot rot.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = SPHLAB_SOURCE_DIR;
constexpr size_t kLongestFile = 400;  // lines
const std::set<std::string> kTopFolders = {"src", "tests", "shaders", "assets", ".ci"};

/// What a folder of src/ may include besides itself, and whether it may see the screen: GL, EGL, GLUT, X11, ImGui.
struct Rule {
  std::set<std::string> may_include;
  bool sees_screen = false;
};

// clang-format off
const std::map<std::string, Rule> kRules = {
    {"base",       {{}}},
    {"particles",  {{"base"}}},
    {"neighbours", {{"base"}}},
    {"sph",        {{"base", "particles", "neighbours"}}},
    {"scenes",     {{"base", "particles", "neighbours", "sph"}}},
    {"io",         {{"base", "particles"}}},
    {"lab",        {{"base", "particles", "neighbours", "sph", "scenes", "io"}}},
    {"render",     {{"base", "particles", "io"}, true}},
    {"headless",   {{"base", "particles", "io", "render"}, true}},
    {"window",     {{"base", "particles", "sph", "scenes", "io", "render"}, true}},
    {"commands",   {{"base", "particles", "neighbours", "sph", "scenes", "io", "lab", "render", "headless", "window"}}},
    {"main.cpp",   {{"base", "particles", "neighbours", "sph", "scenes", "io", "lab", "render", "headless", "window",
                     "commands"}}},
};
// clang-format on

bool IsOfTheScreen(std::string_view header) {
  for (std::string_view start : {"GL/", "EGL/", "GLES", "KHR/", "X11/", "imgui"})
    if (header.starts_with(start)) return true;
  return false;
}

/// What is wrong with a line in a file of `folder`, or "". Other libraries' headers are free, but for the screen's.
std::string Complaint(const std::string& folder, const std::string& line) {
  const size_t open = line.find_first_of("<\"");
  if (open == std::string::npos) return "";
  std::string directive = line.substr(0, open);
  std::erase(directive, ' ');
  if (directive != "#include") return "";
  const std::string header = line.substr(open + 1, line.find_first_of(">\"", open + 1) - open - 1);
  const Rule& rule = kRules.at(folder);
  if (IsOfTheScreen(header)) return rule.sees_screen ? "" : folder + " may not see the screen: " + header;
  const size_t slash = header.find('/');
  if (line[open] == '"' && (slash == std::string::npos || header[0] == '.'))
    return "say \"folder/file.hpp\" instead of " + header;
  const std::string other = header.substr(0, slash);
  const bool allowed = !kRules.contains(other) || other == folder || rule.may_include.contains(other);
  return allowed ? "" : folder + " may not include " + header;
}

/// Does src/`file` begin with a comment? A .cpp may begin with its own header, which has the comment.
bool SaysItsIdea(const fs::path& file, const std::string& first_line) {
  if (first_line.starts_with("//")) return first_line.size() >= 15;  // a few words at least
  return file.extension() == ".cpp" &&
         first_line == "#include \"" + fs::path(file).replace_extension(".hpp").generic_string() + "\"";
}

/// The paths of the project that a line of prose names; of src/sph/<name>.hpp or src/sph/wall.{hpp,cpp} the folder.
std::vector<std::string> PathsIn(std::string line) {
  for (char& c : line)
    if (std::string_view(" \t`'\"()[],;:|").find(c) != std::string_view::npos) c = '\n';
  std::vector<std::string> paths;
  std::istringstream words(line);
  for (std::string word; std::getline(words, word);) {
    const size_t slash = word.find('/');
    if (slash == std::string::npos || !kTopFolders.contains(word.substr(0, slash))) continue;
    const size_t pattern = word.find_first_of("<{*");
    if (pattern != std::string::npos) word.resize(word.rfind('/', pattern));
    while (word.ends_with('.')) word.pop_back();
    paths.push_back(word);
  }
  return paths;
}

std::vector<std::string> Lines(const fs::path& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The C++ files below kRoot/top, in order, relative to it.
std::vector<fs::path> Sources(const char* top) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
    const std::string ending = entry.path().extension();
    if (ending == ".cpp" || ending == ".hpp" || ending == ".h")
      files.push_back(entry.path().lexically_relative(kRoot / top));
  }
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty()) << kRoot / top;
  return files;
}

TEST(Layout, FoldersIncludeOnlyWhatTheTableAllows) {
  for (const fs::path& file : Sources("src")) {
    const std::string folder = *file.begin();
    ASSERT_TRUE(kRules.contains(folder)) << "src/" << folder << " has no row in the table of this test";
    int number = 0;
    for (const std::string& line : Lines(kRoot / "src" / file)) {
      ++number;
      EXPECT_EQ(Complaint(folder, line), "") << "src/" << file.generic_string() << ":" << number;
    }
  }
}

TEST(Layout, EverySourceFileSaysItsIdeaFirst) {
  for (const fs::path& file : Sources("src")) {
    const std::vector<std::string> lines = Lines(kRoot / "src" / file);
    EXPECT_TRUE(!lines.empty() && SaysItsIdea(file, lines[0])) << "src/" << file.generic_string();
  }
}

TEST(Layout, NoFileIsTooLongForOneIdea) {
  for (const char* top : {"src", "tests"})
    for (const fs::path& file : Sources(top))
      EXPECT_LE(Lines(kRoot / top / file).size(), kLongestFile) << top << "/" << file.generic_string();
}

// Two of one name are one to the linker, which takes the functions of either.
TEST(Layout, TypesInHeadersHaveNamesOfTheirOwn) {
  const std::regex type(R"((?:struct|class|enum class) (\w+)[^;]*)");
  std::map<std::string, fs::path> seen;
  for (const char* top : {"src", "tests"}) {
    for (const fs::path& file : Sources(top)) {
      if (file.extension() != ".hpp") continue;
      for (const std::string& line : Lines(kRoot / top / file)) {
        std::smatch parts;
        if (!std::regex_match(line, parts, type)) continue;
        const auto [before, is_new] = seen.emplace(parts[1], file);
        EXPECT_TRUE(is_new) << parts[1] << " in " << file << " and " << before->second;
      }
    }
  }
  EXPECT_GT(seen.size(), 100u) << "are types written in another way now?";
}

TEST(Layout, FilesNamedInTheReadmeExist) {
  for (const std::string& line : Lines(kRoot / "README.md"))
    for (const std::string& path : PathsIn(line)) EXPECT_TRUE(fs::exists(kRoot / path)) << path << " in: " << line;
}

TEST(Layout, ForbiddenLinesAreSeen) {
  EXPECT_NE(Complaint("sph", "#include \"render/view.hpp\""), "");
  EXPECT_NE(Complaint("render", "  #  include <sph/pressure.hpp>  // why not"), "");
  EXPECT_NE(Complaint("lab", "#include \"headless/osmesa.hpp\""), "");
  EXPECT_NE(Complaint("io", "#include <GL/gl.h>"), "");
  EXPECT_NE(Complaint("commands", "#include <imgui.h>"), "");
  EXPECT_NE(Complaint("base", "#include \"vec2.hpp\""), "");
  EXPECT_NE(Complaint("base", "#include \"../sph/kernels.hpp\""), "");
  EXPECT_EQ(Complaint("headless", "#include <EGL/egl.h>"), "");
  EXPECT_EQ(Complaint("sph", "#include \"sph/kernels.hpp\""), "");
  EXPECT_EQ(Complaint("base", "#include <fmt/format.h>"), "");
  EXPECT_FALSE(SaysItsIdea("base/vec2.hpp", "#pragma once"));
  EXPECT_FALSE(SaysItsIdea("base/check.cpp", "#include \"base/vec2.hpp\""));
  EXPECT_EQ(PathsIn("bash tests/run.sh, or (`src/sph/<name>.hpp`); build/src/x"),
            (std::vector<std::string>{"tests/run.sh", "src/sph"}));
}

// A table with a cycle would let every folder reach every other one.
TEST(Layout, TheTableHasNoCycle) {
  std::set<std::string> reached;
  for (size_t round = 0; round < kRules.size(); ++round)
    for (const auto& [folder, rule] : kRules)
      if (std::ranges::includes(reached, rule.may_include)) reached.insert(folder);
  EXPECT_EQ(reached.size(), kRules.size());
}

}  // namespace
