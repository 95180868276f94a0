// freeglut, loaded at run time: a program without a window loads neither it nor OpenGL.
#pragma once

#include <GL/freeglut.h>

#include <span>
#include <string>

namespace sph {

// What the window calls. freeglut.h declares each; only its type is used here: nothing of freeglut is linked. The Ucall
// forms hand a pointer of ours to the callback.
#define SPH_GLUT_FUNCTIONS(X) \
  X(CloseFuncUcall)           \
  X(CreateWindow)             \
  X(DestroyWindow)            \
  X(DisplayFuncUcall)         \
  X(Exit)                     \
  X(Get)                      \
  X(GetProcAddress)           \
  X(IgnoreKeyRepeat)          \
  X(Init)                     \
  X(InitContextProfile)       \
  X(InitContextVersion)       \
  X(InitDisplayMode)          \
  X(InitErrorFunc)            \
  X(InitWindowSize)           \
  X(KeyboardFuncUcall)        \
  X(KeyboardUpFuncUcall)      \
  X(MainLoopEvent)            \
  X(ReshapeFuncUcall)         \
  X(SetOption)                \
  X(SetWindowTitle)           \
  X(SpecialFuncUcall)         \
  X(SpecialUpFuncUcall)       \
  X(SwapBuffers)

/// glut.SwapBuffers() is glutSwapBuffers().
struct GlutFunctions {
#define SPH_GLUT_MEMBER(name) decltype(&::glut##name) name = nullptr;
  SPH_GLUT_FUNCTIONS(SPH_GLUT_MEMBER)
#undef SPH_GLUT_MEMBER
};

/// TroubleError with the library names tried, why each failed and the Debian package that brings one.
GlutFunctions LoadGlut();
GlutFunctions LoadGlut(std::span<const std::string> library_names);

}  // namespace sph
