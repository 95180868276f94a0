// An OpenGL context without a window or a display, through a library loaded at run time.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl_functions.hpp"

namespace sph {

/// Which library brings the context. kAuto: OSMesa (always in software, the same everywhere), else EGL.
enum class Backend { kAuto, kOsmesa, kEgl };

/// The file names tried, in this order, as dlopen takes them; tests name others.
struct BackendLibraries {
  std::vector<std::string> osmesa = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
  std::vector<std::string> egl = {"libEGL.so.1", "libEGL.so"};
};

/// A core profile context of OpenGL 3.3 or later with no framebuffer of its own worth drawing in: draw in an
/// OffscreenTarget. One thread at a time.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  /// Makes this the calling thread's current context; TroubleError if the library refuses.
  virtual void MakeCurrent() = 0;
  virtual GlLoader Loader() const = 0;
  /// "osmesa" or "egl".
  virtual std::string Name() const = 0;
};

/// A new context, current on the calling thread. TroubleError with the libraries tried, why each failed and the Debian
/// package that brings it.
std::unique_ptr<OffscreenContext> MakeOffscreenContext(Backend backend, const BackendLibraries& libraries = {});

/// GL_VERSION and GL_RENDERER of the current context, e.g. "4.5 (Core Profile) Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 256
/// bits)".
std::string DescribeGl(const GlFunctions& gl);

/// For `sphlab info`: whether a back-end works here, tried out.
struct BackendInfo {
  std::string name;
  bool available = false;
  std::string description;  // DescribeGl, or why it is not available
};
std::vector<BackendInfo> FindBackends(const BackendLibraries& libraries = {});

/// "auto", "osmesa" or "egl"; UsageError, with what is accepted, for any other name.
Backend BackendNamed(std::string_view name);

}  // namespace sph
