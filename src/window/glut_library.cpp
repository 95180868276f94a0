#include "window/glut_library.hpp"

#include <vector>

#include "base/library.hpp"

namespace sph {

GlutFunctions LoadGlut() {
  static const std::vector<std::string> names = {"libglut.so.3.12", "libglut.so.3", "libglut.so"};
  return LoadGlut(names);
}

GlutFunctions LoadGlut(std::span<const std::string> library_names) {
  const Library library("freeglut, which opens the window", library_names, "libglut3.12 (with freeglut3-dev)");
  GlutFunctions glut;
#define SPH_GLUT_FIND(name) glut.name = library.Find<decltype(glut.name)>("glut" #name);
  SPH_GLUT_FUNCTIONS(SPH_GLUT_FIND)
#undef SPH_GLUT_FIND
  return glut;
}

}  // namespace sph
