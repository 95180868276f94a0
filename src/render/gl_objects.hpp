// OpenGL's objects with an owner: made with it, deleted with it. The context must be current both times.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/gl_functions.hpp"

namespace sph {

class VertexArray {
 public:
  explicit VertexArray(const GlFunctions& gl) : gl_(gl) { gl_.GenVertexArrays(1, &name_); }
  ~VertexArray() { gl_.DeleteVertexArrays(1, &name_); }
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;

  void Bind() { gl_.BindVertexArray(name_); }

 private:
  const GlFunctions& gl_;
  GLuint name_ = 0;
};

class Buffer {
 public:
  /// @param target  GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
  Buffer(const GlFunctions& gl, GLenum target) : gl_(gl), target_(target) { gl_.GenBuffers(1, &name_); }
  ~Buffer() { gl_.DeleteBuffers(1, &name_); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  void Bind() { gl_.BindBuffer(target_, name_); }
  /// Binds it and gives it new contents, for one frame's use; the old ones may still be in use by the last frame.
  template <typename Span>
  void Upload(const Span& data) {
    Bind();
    gl_.BufferData(target_, static_cast<GLsizeiptr>(data.size() * sizeof(*data.data())), data.data(), GL_STREAM_DRAW);
  }

 private:
  const GlFunctions& gl_;
  GLenum target_;
  GLuint name_ = 0;
};

class Texture {
 public:
  explicit Texture(const GlFunctions& gl) : gl_(gl) { gl_.GenTextures(1, &name_); }
  ~Texture() { gl_.DeleteTextures(1, &name_); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  void Bind() { gl_.BindTexture(GL_TEXTURE_2D, name_); }
  GLuint Name() const { return name_; }

 private:
  const GlFunctions& gl_;
  GLuint name_ = 0;
};

/// A number as OpenGL and Dear ImGui take offsets and names: in a pointer that points nowhere.
inline void* AsPointer(std::uintptr_t number) {
  return reinterpret_cast<void*>(number);  // NOLINT(performance-no-int-to-ptr)
}

/// What a vertex attribute of the buffer bound last is: `size` numbers of `type`, `offset` bytes into each vertex.
inline void SetAttribute(const GlFunctions& gl, GLuint location, GLint size, GLenum type, std::size_t vertex_bytes,
                         std::size_t offset) {
  const GLboolean bytes_mean_fractions = type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE;
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, size, type, bytes_mean_fractions, static_cast<GLsizei>(vertex_bytes),
                         AsPointer(offset));
}

}  // namespace sph
