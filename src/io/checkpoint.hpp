// A saved state as a file: with a version, a length and a checksum, written whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace sph {

/// Replaces `path` by a checkpoint of these bytes, as WriteWholeFile does.
void WriteCheckpoint(const std::filesystem::path& path, std::span<const std::byte> state);

/// The state in a checkpoint. TroubleError with `path` and the reason for a file that cannot be read, is no checkpoint,
/// is of another version, has not all its bytes, or has others than were written: any single byte that differs is
/// noticed.
std::vector<std::byte> ReadCheckpoint(const std::filesystem::path& path);

/// The same from a file's contents; `name` stands for it in errors.
std::vector<std::byte> DecodeCheckpoint(std::span<const std::byte> file, const std::string& name);

}  // namespace sph
