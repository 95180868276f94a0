#include "render/renderer.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/check.hpp"
#include "render/disk_painter.hpp"
#include "render/wall_painter.hpp"

namespace sph {
namespace {

// [pixels] at UI scale 1
constexpr double kWallWidth = 3;
constexpr double kMargin = 12;

}  // namespace

struct Renderer::State {
  State(const GlFunctions& functions, double ui_scale)
      : gl(functions), disks(functions), walls(functions), text(functions, ui_scale) {}

  const GlFunctions& gl;
  DiskPainter disks;
  WallPainter walls;
  TextLayer text;
  View view;
  Colouring colouring = Colouring::kBlackDisks;
  std::optional<ColourRange> fixed_range;
  std::optional<ColourRange> shown_range;
};

Renderer::Renderer(const GlFunctions& gl, double ui_scale) : state_(std::make_unique<State>(gl, ui_scale)) {}
Renderer::~Renderer() = default;

void Renderer::SetColourRange(std::optional<ColourRange> range) {
  SPH_CHECK(!range || range->low < range->high, "from {} to {}", range->low, range->high);
  state_->fixed_range = range;
}
std::optional<ColourRange> Renderer::ShownRange() const { return state_->shown_range; }
void Renderer::SetUiScale(double ui_scale) { state_->text.SetUiScale(ui_scale); }
TextLayer& Renderer::Text() { return state_->text; }
Colouring Renderer::WantedColouring() const { return state_->colouring; }

View Renderer::FittedView(const Box& content, int width, int height) const {
  const TextLayer& text = state_->text;
  return ViewOf(content, width, height, kMargin * text.UiScale(), text.StatusHeight(width, height));
}

void Renderer::BeginFrame(const View& view, Colouring colouring) {
  state_->view = view;
  state_->colouring = colouring;
  state_->disks.Begin(view);
  state_->walls.Begin(view, std::max(1.0, kWallWidth * state_->text.UiScale()));
  state_->text.BeginFrame(view.width, view.height);
}

void Renderer::DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                         std::span<const double> values) {
  state_->disks.Add(x, y, radius, values);
}

void Renderer::DrawWall(Vec2 a, Vec2 b) { state_->walls.Add(a, b); }

void Renderer::EndFrame() {
  State& state = *state_;
  const GlFunctions& gl = state.gl;
  gl.Viewport(0, 0, state.view.width, state.view.height);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.ClearColor(1, 1, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);

  if (const auto fitted = state.disks.Fitted()) {
    state.shown_range = state.fixed_range ? state.fixed_range : fitted;
    state.text.Legend(LegendOf(state.colouring, *state.shown_range));
  }
  state.disks.Draw(state.shown_range);
  state.walls.Draw();
  state.text.EndFrame();
}

Image Renderer::ReadImage() const {
  Image image;
  ReadImage(image);
  return image;
}

void Renderer::ReadImage(Image& image) const {
  const auto height = static_cast<std::size_t>(state_->view.height);
  const std::size_t row = 3 * static_cast<std::size_t>(state_->view.width);  // [bytes]
  image.width = state_->view.width;
  image.height = state_->view.height;
  image.rgb.resize(row * height);
  state_->gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  state_->gl.ReadPixels(0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  for (std::size_t y = 0; y < height / 2; ++y) {  // OpenGL's first row is the lowest
    std::uint8_t* upper = &image.rgb[row * y];
    std::swap_ranges(upper, upper + row, &image.rgb[row * (height - 1 - y)]);
  }
}

}  // namespace sph
