// The OpenGL 3.3 core functions that drawing needs, found through whatever loader the context brings.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <functional>

namespace sph {

/// The address of the named function, e.g. "glClear", in the current context; null if it has none.
using GlLoader = std::function<void*(const char*)>;

// X(type, name). gl.h declares what is as old as OpenGL 1.1 (only its type is used here: nothing GL is linked), glext.h
// names the types of what is newer.
#define SPH_GL_FUNCTIONS(X)                                    \
  X(decltype(&glBindTexture), BindTexture)                     \
  X(decltype(&glBlendFunc), BlendFunc)                         \
  X(decltype(&glClear), Clear)                                 \
  X(decltype(&glClearColor), ClearColor)                       \
  X(decltype(&glDeleteTextures), DeleteTextures)               \
  X(decltype(&glDisable), Disable)                             \
  X(decltype(&glDrawArrays), DrawArrays)                       \
  X(decltype(&glEnable), Enable)                               \
  X(decltype(&glFinish), Finish)                               \
  X(decltype(&glGenTextures), GenTextures)                     \
  X(decltype(&glGetError), GetError)                           \
  X(decltype(&glGetFloatv), GetFloatv)                         \
  X(decltype(&glGetIntegerv), GetIntegerv)                     \
  X(decltype(&glGetString), GetString)                         \
  X(decltype(&glPixelStorei), PixelStorei)                     \
  X(decltype(&glReadPixels), ReadPixels)                       \
  X(decltype(&glScissor), Scissor)                             \
  X(decltype(&glTexImage2D), TexImage2D)                       \
  X(decltype(&glTexParameteri), TexParameteri)                 \
  X(decltype(&glViewport), Viewport)                           \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                     \
  X(PFNGLATTACHSHADERPROC, AttachShader)                       \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                           \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                 \
  X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)               \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                 \
  X(PFNGLBUFFERDATAPROC, BufferData)                           \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)   \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                     \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                     \
  X(PFNGLCREATESHADERPROC, CreateShader)                       \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                     \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)           \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                     \
  X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)         \
  X(PFNGLDELETESHADERPROC, DeleteShader)                       \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)           \
  X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)         \
  X(PFNGLDRAWELEMENTSBASEVERTEXPROC, DrawElementsBaseVertex)   \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray) \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer) \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                           \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                 \
  X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)               \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                 \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)             \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                       \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)               \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                         \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)           \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                         \
  X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)         \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                       \
  X(PFNGLUNIFORM1FPROC, Uniform1f)                             \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                             \
  X(PFNGLUNIFORM2FPROC, Uniform2f)                             \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                           \
  X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor)         \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)

/// gl.Clear(...) is glClear(...): valid in the context that was current when the table was filled.
struct GlFunctions {
#define SPH_GL_MEMBER(type, name) type name = nullptr;
  SPH_GL_FUNCTIONS(SPH_GL_MEMBER)
#undef SPH_GL_MEMBER
};

/// Fills the table for the current context. TroubleError naming the function that the loader does not find, or the
/// version if the context offers less than OpenGL 3.3.
GlFunctions LoadGlFunctions(const GlLoader& loader);

}  // namespace sph
