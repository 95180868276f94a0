// OSMesa: Mesa's OpenGL drawn by the processor into memory; needs no display, device or driver.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "headless/context.hpp"

namespace sph {

/// A new context, current on the calling thread. TroubleError if none of the libraries brings one.
std::unique_ptr<OffscreenContext> MakeOsmesaContext(std::span<const std::string> library_names);

}  // namespace sph
