#include "headless/target.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace sph {
namespace {

void CheckSize(const GlFunctions& gl, int width, int height) {
  GLint buffer_limit = 0;
  GLint viewport_limits[2] = {};
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer_limit);
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport_limits);
  const int width_limit = std::min(buffer_limit, viewport_limits[0]);
  const int height_limit = std::min(buffer_limit, viewport_limits[1]);
  if (width < 1 || height < 1 || width > width_limit || height > height_limit) {
    throw TroubleError("a picture of {} x {} pixels: this OpenGL driver draws 1 x 1 to {} x {}", width, height,
                       width_limit, height_limit);
  }
}

}  // namespace

OffscreenTarget::OffscreenTarget(const GlFunctions& gl, int width, int height) : gl_(gl) {
  CheckSize(gl, width, height);
  gl.GenRenderbuffers(1, &colours_);
  gl.BindRenderbuffer(GL_RENDERBUFFER, colours_);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl.GenFramebuffers(1, &framebuffer_);
  Bind();
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw TroubleError("a picture of {} x {} pixels: the OpenGL driver has no memory for it (status {:#x})", width,
                       height, status);
  }
}

OffscreenTarget::~OffscreenTarget() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &colours_);
}

void OffscreenTarget::Bind() { gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

}  // namespace sph
