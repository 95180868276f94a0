// Shaders and font, put into the program when it is built: it reads no file to draw.
#pragma once

#include <string_view>

namespace sph {

/// The bytes of a file listed in src/render/CMakeLists.txt, by its name without folder: "disks.frag". SPH_CHECK: it is.
std::string_view EmbeddedFile(std::string_view name);

}  // namespace sph
