#include "render/gl_functions.hpp"

#include "base/error.hpp"

namespace sph {
namespace {

template <typename Function>
void Find(const GlLoader& loader, const char* name, Function& function) {
  function = reinterpret_cast<Function>(loader(name));
  if (function == nullptr) {
    throw TroubleError("OpenGL: the driver has no function {}; sphlab needs OpenGL 3.3 core", name);
  }
}

void CheckVersion(const GlFunctions& gl) {
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor >= 33) return;
  const GLubyte* version = gl.GetString(GL_VERSION);
  throw TroubleError("OpenGL: this context offers version '{}'; sphlab needs OpenGL 3.3 core",
                     version == nullptr ? "unknown" : reinterpret_cast<const char*>(version));
}

}  // namespace

GlFunctions LoadGlFunctions(const GlLoader& loader) {
  GlFunctions gl;
#define SPH_GL_FIND(type, name) Find(loader, "gl" #name, gl.name);
  SPH_GL_FUNCTIONS(SPH_GL_FIND)
#undef SPH_GL_FIND
  CheckVersion(gl);
  return gl;
}

}  // namespace sph
