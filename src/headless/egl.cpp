#include "headless/egl.hpp"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <string_view>

#include "base/error.hpp"
#include "base/library.hpp"

namespace sph {
namespace {

/// What is used of EGL 1.5.
struct EglFunctions {
  explicit EglFunctions(const Library& library)
      : bind_api(library.Find<PFNEGLBINDAPIPROC>("eglBindAPI")),
        choose_config(library.Find<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")),
        create_context(library.Find<PFNEGLCREATECONTEXTPROC>("eglCreateContext")),
        destroy_context(library.Find<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")),
        get_error(library.Find<PFNEGLGETERRORPROC>("eglGetError")),
        get_platform_display(library.Find<PFNEGLGETPLATFORMDISPLAYPROC>("eglGetPlatformDisplay")),
        get_proc_address(library.Find<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress")),
        initialize(library.Find<PFNEGLINITIALIZEPROC>("eglInitialize")),
        make_current(library.Find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")),
        query_string(library.Find<PFNEGLQUERYSTRINGPROC>("eglQueryString")) {}

  PFNEGLBINDAPIPROC bind_api;
  PFNEGLCHOOSECONFIGPROC choose_config;
  PFNEGLCREATECONTEXTPROC create_context;
  PFNEGLDESTROYCONTEXTPROC destroy_context;
  PFNEGLGETERRORPROC get_error;
  PFNEGLGETPLATFORMDISPLAYPROC get_platform_display;
  PFNEGLGETPROCADDRESSPROC get_proc_address;
  PFNEGLINITIALIZEPROC initialize;
  PFNEGLMAKECURRENTPROC make_current;
  PFNEGLQUERYSTRINGPROC query_string;
};

/// Whether `wanted` is one of the words of `extensions`, which may be null.
bool Offers(const char* extensions, std::string_view wanted) {
  std::istringstream words(extensions == nullptr ? "" : extensions);
  return std::find(std::istream_iterator<std::string>(words), {}, wanted) != std::istream_iterator<std::string>();
}

class EglContext final : public OffscreenContext {
 public:
  explicit EglContext(const Library& library) : egl_(library) {
    const char* extensions = egl_.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (Offers(extensions, "EGL_MESA_platform_surfaceless")) Try(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
    if (Offers(extensions, "EGL_EXT_platform_device") && Offers(extensions, "EGL_EXT_device_enumeration")) TryDevices();
    if (context_ == EGL_NO_CONTEXT) {
      throw TroubleError(
          "EGL: no context of OpenGL 3.3 core without a window;{}\nOn Debian the package libegl-mesa0 brings one.",
          failures_.empty() ? " it offers neither the surfaceless nor the device platform" : " tried" + failures_);
    }
  }
  ~EglContext() override {
    // The display stays initialised: it is one for the whole process, so eglTerminate would end other contexts too.
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void MakeCurrent() override {
    // Mesa's OSMesa and EGL share one record of the current context, but EGL keeps its own too and does nothing if the
    // context is current by that: after an OSMesa context was, only letting go first makes ours current again.
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      throw TroubleError("EGL: it refuses to make its context the current one (error {:#x})", egl_.get_error());
    }
  }
  GlLoader Loader() const override {
    return [find = egl_.get_proc_address](const char* name) { return reinterpret_cast<void*>(find(name)); };
  }
  std::string Name() const override { return "egl"; }

 private:
  void TryDevices() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl_.get_proc_address("eglQueryDevicesEXT"));
    std::array<EGLDeviceEXT, 16> devices = {};
    EGLint count = 0;
    if (query == nullptr || query(devices.size(), devices.data(), &count) == EGL_FALSE) return;
    for (EGLint i = 0; i < count; ++i) Try(EGL_PLATFORM_DEVICE_EXT, devices[i]);
  }

  /// Makes the context on that platform, unless there is one already; notes why not.
  void Try(EGLenum platform, void* native_display) {
    if (context_ != EGL_NO_CONTEXT) return;
    const char* failed = TryContext(platform, native_display);
    if (failed == nullptr) return;
    context_ = EGL_NO_CONTEXT;
    failures_ += fmt::format("\n  the {} platform: {} failed (error {:#x})",
                             platform == EGL_PLATFORM_DEVICE_EXT ? "device" : "surfaceless", failed, egl_.get_error());
  }

  /// The function that failed, or null when context_ is made and can be current.
  const char* TryContext(EGLenum platform, void* native_display) {
    display_ = egl_.get_platform_display(platform, native_display, nullptr);
    if (display_ == EGL_NO_DISPLAY) return "eglGetPlatformDisplay";
    if (egl_.initialize(display_, nullptr, nullptr) == EGL_FALSE) return "eglInitialize";
    if (egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE) return "eglBindAPI";
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl_.choose_config(display_, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
      return "eglChooseConfig";
    }
    const std::array<EGLint, 7> version = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, version.data());
    if (context_ == EGL_NO_CONTEXT) return "eglCreateContext";
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE) return nullptr;
    egl_.destroy_context(display_, context_);
    return "eglMakeCurrent";
  }

  EglFunctions egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string failures_;
};

}  // namespace

std::unique_ptr<OffscreenContext> MakeEglContext(std::span<const std::string> library_names) {
  auto context = std::make_unique<EglContext>(Library("EGL", library_names, "libegl1"));
  context->MakeCurrent();
  return context;
}

}  // namespace sph
