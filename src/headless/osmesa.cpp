#include "headless/osmesa.hpp"

#include <array>

#include "base/error.hpp"
#include "base/library.hpp"

namespace sph {
namespace {

// The part of OSMesa's interface that is used here, stated by us: its header lies in a package that nothing else needs.
using OsmesaContextHandle = struct OsmesaContextTag*;
using OsmesaFunction = void (*)();
using CreateContextFunction = OsmesaContextHandle (*)(const int* attributes, OsmesaContextHandle sharing);
using MakeCurrentFunction = GLboolean (*)(OsmesaContextHandle, void* pixels, GLenum type, GLsizei width,
                                          GLsizei height);
using DestroyContextFunction = void (*)(OsmesaContextHandle);
using GetProcAddressFunction = OsmesaFunction (*)(const char* name);
constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

class OsmesaContext final : public OffscreenContext {
 public:
  explicit OsmesaContext(const Library& library)
      : make_current_(library.Find<MakeCurrentFunction>("OSMesaMakeCurrent")),
        destroy_(library.Find<DestroyContextFunction>("OSMesaDestroyContext")),
        get_proc_address_(library.Find<GetProcAddressFunction>("OSMesaGetProcAddress")) {
    const auto create = library.Find<CreateContextFunction>("OSMesaCreateContextAttribs");
    const std::array attributes = {kFormat, GL_RGBA, kProfile, kCoreProfile, kMajorVersion, 3, kMinorVersion, 3, 0};
    context_ = create(attributes.data(), nullptr);
    if (context_ == nullptr) throw TroubleError("OSMesa: it refuses to make a context of OpenGL 3.3 core");
  }
  ~OsmesaContext() override {
    make_current_(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    destroy_(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void MakeCurrent() override {
    // OSMesa wants a default framebuffer; one pixel is enough, since an OffscreenTarget is drawn in.
    if (make_current_(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
      throw TroubleError("OSMesa: it refuses to make its context the current one");
    }
  }
  GlLoader Loader() const override {
    return [find = get_proc_address_](const char* name) { return reinterpret_cast<void*>(find(name)); };
  }
  std::string Name() const override { return "osmesa"; }

 private:
  MakeCurrentFunction make_current_;
  DestroyContextFunction destroy_;
  GetProcAddressFunction get_proc_address_;
  OsmesaContextHandle context_ = nullptr;
  std::array<GLubyte, 4> pixel_ = {};
};

}  // namespace

std::unique_ptr<OffscreenContext> MakeOsmesaContext(std::span<const std::string> library_names) {
  auto context = std::make_unique<OsmesaContext>(Library("OSMesa", library_names, "libosmesa6"));
  context->MakeCurrent();
  return context;
}

}  // namespace sph
