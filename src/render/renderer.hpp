// Draws disks, walls, legend and text in whatever OpenGL 3.3 context is current.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "io/image.hpp"
#include "particles/canvas.hpp"
#include "render/colour_range.hpp"
#include "render/gl_functions.hpp"
#include "render/text.hpp"
#include "render/view.hpp"

namespace sph {

/// A frame: BeginFrame, the Canvas methods (usually through ParticleSystem::Draw), Text() for what is written over it,
/// EndFrame, which draws all of it: walls over disks, text over both. Everything is drawn into the framebuffer that is
/// bound when EndFrame is called. Where the window shows nothing, the picture is white.
class Renderer final : public Canvas {
 public:
  /// Compiles the shaders; TroubleError with file name and log if the driver refuses one. The context of `gl` must be
  /// current here, in every method and in the destructor; `gl` must outlive this object.
  /// @param ui_scale  > 0; text of 15 pixels and walls of 3 at scale 1.
  explicit Renderer(const GlFunctions& gl, double ui_scale = 1);
  ~Renderer() override;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The colour range of all later frames; without one it is fitted to the values of each frame.
  void SetColourRange(std::optional<ColourRange> range);
  /// The range of the last frame that showed values, fixed or fitted.
  std::optional<ColourRange> ShownRange() const;
  void SetUiScale(double ui_scale);
  /// Status line, message and help of the frame begun last.
  TextLayer& Text();

  /// The view that shows `content` [m] as large as a window of that size allows, with a small margin and room for the
  /// status line above it.
  View FittedView(const Box& content, int width, int height) const;

  void BeginFrame(const View& view, Colouring colouring);
  Colouring WantedColouring() const override;
  /// Disks with smooth edges, whose ink is that of the true disk: pi r^2 pixels, also below a pixel. Black without
  /// values; with them, coloured, and red where a value is not a number. What is outside the window, or nowhere (NaN),
  /// is left out.
  void DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                 std::span<const double> values) override;
  void DrawWall(Vec2 a, Vec2 b) override;
  void EndFrame();

  /// The picture in the framebuffer bound for reading, of the size of the last frame.
  Image ReadImage() const;
  /// The same into `image`, whose memory is used again.
  void ReadImage(Image& image) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sph
