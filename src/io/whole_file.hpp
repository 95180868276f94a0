// A file is written whole or not at all: no reader and no crash ever meets half of one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace sph {

/// Makes `path` a file of exactly these bytes: they go to a temporary file beside it and onto the disk (fsync), then
/// the temporary takes the name (rename). A symbolic link is followed, an existing file's permissions are kept, and
/// what is not a regular file (/dev/stdout, a pipe) is written directly. TroubleError with `path`, what was tried and
/// why it failed; then an existing `path` is untouched and the temporary gone.
void WriteWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
void WriteWholeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace sph
