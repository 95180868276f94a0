// EGL without a window: on the graphics card if its driver offers that, else Mesa's OpenGL in software.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "headless/context.hpp"

namespace sph {

/// A new context, current on the calling thread: on the surfaceless platform, else on the first device that gives one.
/// TroubleError if none of the libraries brings one.
std::unique_ptr<OffscreenContext> MakeEglContext(std::span<const std::string> library_names);

}  // namespace sph
