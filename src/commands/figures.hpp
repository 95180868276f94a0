// `sphlab figures`: the paper's three figures, made anew.
#pragma once

#include <filesystem>

namespace sph {

/// Writes figure1.png (the dam break in snapshots), figure2.png (the toy star coming to rest) and figure3.png (its
/// density against the exact one) into the folder `out`, which is made if missing. TroubleError if a file cannot be
/// written, no context can be had to draw in, or a run breaks down.
void MakeFigures(const std::filesystem::path& out);

}  // namespace sph
