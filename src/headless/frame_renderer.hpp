// Frames drawn without a window, as pictures in memory.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "headless/context.hpp"
#include "io/image.hpp"
#include "render/renderer.hpp"

namespace sph {

/// What is written over a frame; empty for nothing.
struct FrameText {
  std::string status;
  std::string message;
};

/// Owns a context, a framebuffer of width x height pixels and a Renderer.
class FrameRenderer {
 public:
  /// TroubleError if no context can be had, or if width x height is more than it can draw. The UI scale is UiScaleFor.
  FrameRenderer(Backend backend, int width, int height, const BackendLibraries& libraries = {});
  ~FrameRenderer();
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;

  /// The picture of `region` [m], fitted by Renderer::FittedView, after `draw` (usually ParticleSystem::Draw) has drawn
  /// on the canvas that it is given.
  Image Render(const Box& region, Colouring colouring, const std::function<void(Canvas&)>& draw,
               const FrameText& text = {});
  /// The same into `image`, whose memory is used again.
  void Render(const Box& region, Colouring colouring, const std::function<void(Canvas&)>& draw, const FrameText& text,
              Image& image);

  void SetColourRange(std::optional<ColourRange> range);
  int Width() const;
  int Height() const;
  /// "osmesa" or "egl", and DescribeGl.
  const std::string& BackendName() const;
  const std::string& GlDescription() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sph
