#include "headless/frame_recorder.hpp"

#include <future>
#include <thread>

#include "base/clock.hpp"
#include "base/hand_over.hpp"
#include "headless/frame_renderer.hpp"
#include "io/png.hpp"
#include "render/snapshot.hpp"

namespace sph {
namespace {

/// A frame to be drawn.
struct Frame {
  std::filesystem::path file;
  Box region;
  Snapshot snapshot;
};

/// A frame to be written.
struct Picture {
  std::filesystem::path file;
  Image image;
};

}  // namespace

struct FrameRecorder::State {
  ~State() { EndThreads(); }

  void EndThreads();
  void DrawFrames(Backend backend, int width, int height, const BackendLibraries& libraries);
  void DrawFrame(FrameRenderer& renderer, const Frame& frame);
  void WritePictures();

  HandOver<Frame> frames;
  HandOver<Picture> pictures;
  std::promise<void> started;
  std::string backend_name;
  std::string gl_description;
  double drawing_seconds = 0;
  double writing_seconds = 0;
  std::thread drawer;
  std::thread writer;
};

/// An OpenGL context belongs to a thread: it is made, used and deleted in this one.
void FrameRecorder::State::DrawFrames(Backend backend, int width, int height, const BackendLibraries& libraries) {
  std::unique_ptr<FrameRenderer> renderer;
  try {
    renderer = std::make_unique<FrameRenderer>(backend, width, height, libraries);
    backend_name = renderer->BackendName();
    gl_description = renderer->GlDescription();
    started.set_value();
  } catch (...) {
    started.set_exception(std::current_exception());
  }
  try {
    while (const Frame* frame = renderer ? frames.NextFull() : nullptr) {
      DrawFrame(*renderer, *frame);
      frames.Return();
    }
  } catch (...) {
    frames.Fail(std::current_exception());
  }
}

void FrameRecorder::State::DrawFrame(FrameRenderer& renderer, const Frame& frame) {
  Picture& picture = pictures.NextFree();
  const Stopwatch watch;
  picture.file = frame.file;
  renderer.Render(
      frame.region, frame.snapshot.WantedColouring(), [&](Canvas& canvas) { frame.snapshot.DrawOn(canvas); }, {},
      picture.image);
  drawing_seconds += watch.Seconds();
  pictures.Pass();
}

void FrameRecorder::State::WritePictures() {
  try {
    while (const Picture* picture = pictures.NextFull()) {
      const Stopwatch watch;
      WritePng(picture->file, picture->image);
      writing_seconds += watch.Seconds();
      pictures.Return();
    }
  } catch (...) {
    pictures.Fail(std::current_exception());
    frames.Fail(std::current_exception());
  }
}

void FrameRecorder::State::EndThreads() {
  frames.End();
  if (drawer.joinable()) drawer.join();
  pictures.End();
  if (writer.joinable()) writer.join();
}

FrameRecorder::FrameRecorder(Backend backend, int width, int height, const BackendLibraries& libraries)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.writer = std::thread([&state] { state.WritePictures(); });
  state.drawer =
      std::thread([&state, backend, width, height, libraries] { state.DrawFrames(backend, width, height, libraries); });
  state.started.get_future().get();
}

FrameRecorder::~FrameRecorder() = default;

void FrameRecorder::Record(const std::filesystem::path& file, const Box& region, Colouring colouring,
                           const std::function<void(Canvas&)>& draw) {
  Frame& frame = state_->frames.NextFree();
  frame.file = file;
  frame.region = region;
  frame.snapshot.Begin(colouring);
  draw(frame.snapshot);
  state_->frames.Pass();
}

void FrameRecorder::Finish() {
  state_->EndThreads();
  state_->frames.Check();
}

const std::string& FrameRecorder::BackendName() const { return state_->backend_name; }
const std::string& FrameRecorder::GlDescription() const { return state_->gl_description; }
double FrameRecorder::DrawingSeconds() const { return state_->drawing_seconds; }
double FrameRecorder::WritingSeconds() const { return state_->writing_seconds; }

}  // namespace sph
