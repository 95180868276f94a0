#include "headless/frame_renderer.hpp"

#include "headless/target.hpp"

namespace sph {

struct FrameRenderer::State {
  State(Backend backend, int width_pixels, int height_pixels, const BackendLibraries& libraries)
      : context(MakeOffscreenContext(backend, libraries)),
        gl(LoadGlFunctions(context->Loader())),
        target(gl, width_pixels, height_pixels),
        renderer(gl, UiScaleFor(width_pixels, height_pixels)),
        width(width_pixels),
        height(height_pixels),
        name(context->Name()),
        description(DescribeGl(gl)) {}

  std::unique_ptr<OffscreenContext> context;
  GlFunctions gl;
  OffscreenTarget target;
  Renderer renderer;
  int width;
  int height;
  std::string name;
  std::string description;
};

FrameRenderer::FrameRenderer(Backend backend, int width, int height, const BackendLibraries& libraries)
    : state_(std::make_unique<State>(backend, width, height, libraries)) {}

FrameRenderer::~FrameRenderer() {
  try {
    state_->context->MakeCurrent();  // what the members delete is in it
  } catch (const std::exception&) {
    // Then their deletions find no context and do nothing.
  }
}

Image FrameRenderer::Render(const Box& region, Colouring colouring, const std::function<void(Canvas&)>& draw,
                            const FrameText& text) {
  Image image;
  Render(region, colouring, draw, text, image);
  return image;
}

void FrameRenderer::Render(const Box& region, Colouring colouring, const std::function<void(Canvas&)>& draw,
                           const FrameText& text, Image& image) {
  State& state = *state_;
  state.context->MakeCurrent();
  state.target.Bind();
  state.renderer.BeginFrame(state.renderer.FittedView(region, state.width, state.height), colouring);
  draw(state.renderer);
  state.renderer.Text().StatusLine(text.status);
  state.renderer.Text().Message(text.message);
  state.renderer.EndFrame();
  state.renderer.ReadImage(image);
}

void FrameRenderer::SetColourRange(std::optional<ColourRange> range) { state_->renderer.SetColourRange(range); }
int FrameRenderer::Width() const { return state_->width; }
int FrameRenderer::Height() const { return state_->height; }
const std::string& FrameRenderer::BackendName() const { return state_->name; }
const std::string& FrameRenderer::GlDescription() const { return state_->description; }

}  // namespace sph
