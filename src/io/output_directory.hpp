// The directory that results go to.
#pragma once

#include <filesystem>

namespace sph {

/// Creates `path` and its parents where missing. TroubleError if it cannot be created, is not a directory or cannot be
/// written to: found before the work starts, not after.
void PrepareOutputDirectory(const std::filesystem::path& path);

}  // namespace sph
