// Scenes written in the tests themselves: a small valid one to change, and what is said of a wrong one.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace sph {

/// A valid scene: 100 particles of Tait's fluid above a floor. Its line numbers are known to the tests.
extern const std::string kScene;

/// kScene with `from`, which has to be in it, replaced by `to`.
std::string Changed(const std::string& from, const std::string& to);

/// A file of its own for as long as the object lives.
class TextFile {
 public:
  explicit TextFile(const std::string& text);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  const std::filesystem::path& Path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The scene that the text describes, with settings.
Scene SceneFrom(const std::string& text, const std::vector<std::string>& settings = {});

/// The message with which the text is refused as a usage error, FILE standing for the file's path; "accepted" if it is
/// not.
std::string Refusal(const std::string& text, const std::vector<std::string>& settings = {});

/// Whether all the parts are in the text, for EXPECT_TRUE: an AssertionResult that shows both.
::testing::AssertionResult Has(const std::string& text, const std::vector<std::string>& parts);

}  // namespace sph
