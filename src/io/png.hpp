// Pictures as PNG files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "io/image.hpp"

namespace sph {

/// The bytes of a PNG file of `image`, with settings chosen for speed on frames of a simulation; see png.cpp.
/// SPH_CHECK: the image has at least one pixel and as many bytes as its size says.
std::vector<std::byte> EncodePng(const Image& image);

/// Writes `image` whole or not at all, as WriteWholeFile does; TroubleError naming `path` if the file cannot be
/// written.
void WritePng(const std::filesystem::path& path, const Image& image);

/// Reads any PNG file as 8-bit RGB; what is transparent is laid on white. TroubleError naming `path` if it cannot be
/// read.
Image ReadPng(const std::filesystem::path& path);

}  // namespace sph
