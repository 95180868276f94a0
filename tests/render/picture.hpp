// Pictures drawn for a test, and what can be measured of them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "headless/context.hpp"
#include "headless/target.hpp"
#include "render/renderer.hpp"

namespace sph {

/// A renderer in a context and framebuffer of its own.
class Easel {
 public:
  Easel(int width, int height, double ui_scale = 1)
      : context_(MakeOffscreenContext(Backend::kOsmesa)),
        gl_(LoadGlFunctions(context_->Loader())),
        target_(gl_, width, height),
        renderer_(gl_, ui_scale) {}
  ~Easel() { EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR)); }
  Easel(const Easel&) = delete;
  Easel& operator=(const Easel&) = delete;

  Image Draw(const View& view, Colouring colouring, const std::function<void(Renderer&)>& draw) {
    renderer_.BeginFrame(view, colouring);
    draw(renderer_);
    renderer_.EndFrame();
    return renderer_.ReadImage();
  }
  /// In black disks; one metre is one pixel, the origin at the window's lower left corner.
  Image DrawInPixels(int width, int height, const std::function<void(Renderer&)>& draw) {
    return Draw({{0, 0, static_cast<double>(width), static_cast<double>(height)}, width, height},
                Colouring::kBlackDisks, draw);
  }
  Renderer& GetRenderer() { return renderer_; }
  const GlFunctions& Gl() const { return gl_; }

 private:
  std::unique_ptr<OffscreenContext> context_;
  GlFunctions gl_;
  OffscreenTarget target_;
  Renderer renderer_;
};

/// How black the pixel in column x and row y from the top is: 0 white, 1 black.
inline double Ink(const Image& image, int x, int y) { return (255 - image.Pixel(x, y)[0]) / 255.0; }

/// How many black pixels the ink of the picture would fill, and where their centre of mass is [pixels, y downwards].
struct InkMass {
  double area = 0;
  Vec2 centre;
};

inline InkMass Weigh(const Image& image) {
  InkMass mass;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double ink = Ink(image, x, y);
      mass.area += ink;
      mass.centre = mass.centre + ink * Vec2{x + 0.5, y + 0.5};
    }
  }
  mass.centre = (1 / mass.area) * mass.centre;
  return mass;
}

/// The part of a picture that begins `left` and `top` pixels from its corner.
inline Image Crop(const Image& image, int left, int top, int width, int height) {
  Image part{width, height, {}};
  for (int y = top; y < top + height; ++y) {
    part.rgb.insert(part.rgb.end(), image.Pixel(left, y), image.Pixel(left, y) + std::ptrdiff_t{3} * width);
  }
  return part;
}

/// The largest difference of two pictures of one size in any byte.
inline int LargestDifference(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgb.size(), b.rgb.size());
  int largest = 0;
  for (std::size_t i = 0; i < a.rgb.size() && i < b.rgb.size(); ++i) {
    largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
  }
  return largest;
}

}  // namespace sph
