// A scene in a window, with a person at the keyboard.
#pragma once

#include <functional>

#include "base/error.hpp"
#include "scenes/request.hpp"

namespace sph {

/// Opens a window (freeglut, OpenGL 3.3 core) and returns when it is closed: kDone; kInterrupted as soon as
/// `interrupted` says so. It is asked 60 times a second. UsageError or TroubleError if there is no such scene, no
/// display, no freeglut or no OpenGL 3.3.
ExitCode RunWindow(const SceneRequest& request, const std::function<bool()>& interrupted = {});

}  // namespace sph
