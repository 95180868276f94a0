// A vertex and a fragment shader, compiled and linked.
#pragma once

#include <string_view>

#include "render/gl_functions.hpp"

namespace sph {

class ShaderProgram {
 public:
  /// From two embedded files of shaders/. TroubleError with file name and the driver's log if it refuses one.
  ShaderProgram(const GlFunctions& gl, std::string_view vertex_file, std::string_view fragment_file);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void Use();
  /// Sets a uniform of the program in use. SPH_CHECK: the program has it.
  void Set(const char* name, float value);
  void Set(const char* name, float x, float y);
  void Set(const char* name, int value);

 private:
  GLint Location(const char* name) const;

  const GlFunctions& gl_;
  GLuint name_ = 0;
};

/// A compiled shader; the caller deletes it. TroubleError with `file` and the driver's log if it refuses `source`.
/// @param kind  GL_VERTEX_SHADER or GL_FRAGMENT_SHADER
GLuint CompileShader(const GlFunctions& gl, GLenum kind, std::string_view file, std::string_view source);

}  // namespace sph
