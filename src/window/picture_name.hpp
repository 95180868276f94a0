// The name of the file that the key s writes.
#pragma once

#include <filesystem>
#include <string>

namespace sph {

/// folder/sphlab_<scene>_<number>.png with the first number from 1 on that no file has.
std::filesystem::path NextPictureName(const std::filesystem::path& folder, const std::string& scene);

}  // namespace sph
