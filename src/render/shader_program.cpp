#include "render/shader_program.hpp"

#include <string>

#include "base/check.hpp"
#include "base/error.hpp"
#include "render/embedded.hpp"

namespace sph {
namespace {

constexpr GLsizei kLogLimit = 4096;  // [bytes]

}  // namespace

GLuint CompileShader(const GlFunctions& gl, GLenum kind, std::string_view file, std::string_view source) {
  const GLuint shader = gl.CreateShader(kind);
  const GLchar* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader, 1, &text, &length);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::string log(kLogLimit, '\0');
  gl.GetShaderInfoLog(shader, kLogLimit, nullptr, log.data());
  gl.DeleteShader(shader);
  throw TroubleError("shader {}: the OpenGL driver cannot compile it:\n{}", file, log.c_str());
}

ShaderProgram::ShaderProgram(const GlFunctions& gl, std::string_view vertex_file, std::string_view fragment_file)
    : gl_(gl), name_(gl.CreateProgram()) {
  for (const auto& [kind, file] : {std::pair(GL_VERTEX_SHADER, vertex_file), {GL_FRAGMENT_SHADER, fragment_file}}) {
    const GLuint shader = CompileShader(gl, kind, file, EmbeddedFile(file));
    gl.AttachShader(name_, shader);
    gl.DeleteShader(shader);  // lives as long as the program that it is attached to
  }
  gl.LinkProgram(name_);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::string log(kLogLimit, '\0');
  gl.GetProgramInfoLog(name_, kLogLimit, nullptr, log.data());
  throw TroubleError("shaders {} and {}: the OpenGL driver cannot link them:\n{}", vertex_file, fragment_file,
                     log.c_str());
}

ShaderProgram::~ShaderProgram() { gl_.DeleteProgram(name_); }

void ShaderProgram::Use() { gl_.UseProgram(name_); }
void ShaderProgram::Set(const char* name, float value) { gl_.Uniform1f(Location(name), value); }
void ShaderProgram::Set(const char* name, float x, float y) { gl_.Uniform2f(Location(name), x, y); }
void ShaderProgram::Set(const char* name, int value) { gl_.Uniform1i(Location(name), value); }

GLint ShaderProgram::Location(const char* name) const {
  const GLint location = gl_.GetUniformLocation(name_, name);
  SPH_CHECK(location >= 0, "no uniform {}", name);
  return location;
}

}  // namespace sph
