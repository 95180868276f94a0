#include "window/picture_name.hpp"

#include <fmt/format.h>

namespace sph {

std::filesystem::path NextPictureName(const std::filesystem::path& folder, const std::string& scene) {
  for (int number = 1;; ++number) {
    std::filesystem::path path = folder / fmt::format("sphlab_{}_{:03}.png", scene, number);
    std::error_code unreadable;  // then writing will say what is wrong with it
    if (!std::filesystem::exists(std::filesystem::symlink_status(path, unreadable))) return path;
  }
}

}  // namespace sph
