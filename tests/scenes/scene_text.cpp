#include "scenes/scene_text.hpp"

#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "scenes/scene_file.hpp"

namespace sph {

const std::string kScene = R"(title = "Test"
[fluid]
particles = 100
mass = 0.01
region = { box = [0.0, 0.0, 1.0, 1.0] }
[equation_of_state]
tait = { k = 0.5, rho0 = 1.0 }
[method]
smoothing_length = 0.2
time_step = 0.001
[[wall]]
name = "floor"
at = -0.1
fluid = "above"
range = [-0.5, 0.5]
)";

std::string Changed(const std::string& from, const std::string& to) {
  std::string text = kScene;
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TextFile::TextFile(const std::string& text) {
  static int count = 0;
  path_ = std::filesystem::path(::testing::TempDir()) /
          ("sphlab-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".toml");
  std::ofstream(path_, std::ios::binary) << text;
}

TextFile::~TextFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

Scene SceneFrom(const std::string& text, const std::vector<std::string>& settings) {
  const TextFile file(text);
  return ReadScene(file.Path(), settings);
}

std::string Refusal(const std::string& text, const std::vector<std::string>& settings) {
  const TextFile file(text);
  try {
    ReadScene(file.Path(), settings);
  } catch (const Error& error) {
    EXPECT_EQ(error.Code(), ExitCode::kUsage) << error.what();
    std::string message = error.what();
    const std::string path = file.Path().string();
    for (auto place = message.find(path); place != std::string::npos; place = message.find(path)) {
      message.replace(place, path.size(), "FILE");
    }
    return message;
  }
  return "accepted";
}

::testing::AssertionResult Has(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos)
      return ::testing::AssertionFailure() << "no '" << part << "' in: " << text;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace sph
