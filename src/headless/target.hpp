// The framebuffer that is drawn in when there is no window: the same for every back-end, so that they give the same
// pixels.
#pragma once

#include "render/gl_functions.hpp"

namespace sph {

/// 8-bit red, green, blue, alpha; no depth, no multisampling (the shaders smooth their own edges).
class OffscreenTarget {
 public:
  /// Bound for drawing and reading from now on. TroubleError, with the limit, if the driver cannot draw width x height.
  OffscreenTarget(const GlFunctions& gl, int width, int height);
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  void Bind();

 private:
  const GlFunctions& gl_;
  GLuint colours_ = 0;
  GLuint framebuffer_ = 0;
};

}  // namespace sph
