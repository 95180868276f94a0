#include "commands/render.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "base/memory.hpp"
#include "commands/interrupt.hpp"
#include "commands/messages.hpp"
#include "headless/frame_recorder.hpp"
#include "io/output_directory.hpp"
#include "scenes/build.hpp"
#include "window/key_script.hpp"

namespace sph {
namespace {

struct Size {
  int width = 0;
  int height = 0;
};

Size ReadSize(const std::string& text) {
  constexpr int kMost = 16384;
  Size size;
  const char* end = text.data() + text.size();
  const auto [x, width_error] = std::from_chars(text.data(), end, size.width);
  const bool separated = width_error == std::errc() && x != end && *x == 'x';
  const auto [rest, height_error] = std::from_chars(separated ? x + 1 : end, end, size.height);
  const bool in_range = size.width > 0 && size.width <= kMost && size.height > 0 && size.height <= kMost;
  if (!separated || height_error != std::errc() || rest != end || !in_range) {
    throw UsageError("--size {}: it takes WIDTHxHEIGHT in pixels, each from 1 to {}, such as 1280x720", text, kMost);
  }
  return size;
}

std::filesystem::path FrameFile(const std::filesystem::path& folder, long frame) {
  return folder / fmt::format("frame_{:06}.png", frame);
}

/// How many frames: --frames, or as many as there are up to `until`, whichever are fewer.
long CountFrames(const RenderOptions& options, double until) {
  constexpr double kRoundOff = 1e-6;
  constexpr double kMost = 1e8;
  if (options.frames && !options.until) return *options.frames;
  const double count = std::floor(until * options.fps + kRoundOff) + 1;
  if (!options.frames && count > kMost) {
    throw UsageError("--fps {} up to {} s makes {} frames; it takes at most {}", options.fps, until, count, kMost);
  }
  return static_cast<long>(options.frames ? std::min(count, static_cast<double>(*options.frames)) : count);
}

/// Has a session drawn, each picture a file.
class FrameWriter {
 public:
  FrameWriter(const RenderOptions& options, Size size)
      : folder_(options.out), recorder_(BackendNamed(options.backend), size.width, size.height) {}

  void Write(const Session& session, const std::filesystem::path& file) {
    recorder_.Record(file, InitialView(session.CurrentScene()), session.colouring,
                     [&](Canvas& canvas) { session.System().Draw(canvas); });
  }
  /// Forgets the frames that are due at or after `time` [s], which then are to be drawn again: the system has gone
  /// back.
  void Rewind(double time, double fps) {
    while (frames_ > 0 && static_cast<double>(frames_ - 1) / fps >= time) --frames_;
  }
  void WriteFrame(const Session& session) { Write(session, FrameFile(folder_, frames_++)); }
  /// What the key s asks for: one more picture, named after the frame that it comes before.
  void WriteSaved(const Session& session) { Write(session, folder_ / fmt::format("saved_{:06}.png", frames_)); }
  /// Waits for the last file.
  void Finish() { recorder_.Finish(); }

  long Frames() const { return frames_; }
  const FrameRecorder& Recorder() const { return recorder_; }

 private:
  std::filesystem::path folder_;
  FrameRecorder recorder_;
  long frames_ = 0;
};

}  // namespace

ExitCode RenderScene(const RenderOptions& options) {
  CatchInterrupts();
  KeepFreedMemory();
  const Size size = ReadSize(options.size);
  Session session(options.common.request);
  NotePlacement(session.CurrentScene(), options.common.quiet);
  KeyScript keys(options.common.keys, session.CurrentScene());
  const long wanted = CountFrames(options, options.until.value_or(session.CurrentScene().until));
  FrameWriter writer(options, size);
  PrepareOutputDirectory(options.out);
  constexpr double kRoundOff = 1e-6;  // of a time step
  const Stopwatch watch;
  while (writer.Frames() < wanted && !session.System().Trouble() && !Interrupted()) {
    const double due = static_cast<double>(writer.Frames()) / options.fps;
    keys.Play(session);
    PassOnMessage(session, options.common.quiet);
    if (session.save_requested) writer.WriteSaved(session);
    session.save_requested = false;
    if (session.quit_requested) break;
    if (session.System().Time() >= due - kRoundOff * session.System().parameters.time_step) {
      writer.WriteFrame(session);
    } else {
      const long before = session.System().Steps();
      if (!session.StepUnlessPaused()) break;  // no later key can be reached
      if (session.System().Steps() <= before) writer.Rewind(session.System().Time(), options.fps);
    }
  }
  writer.Finish();
  if (options.common.json) {
    const nlohmann::ordered_json report = {{"scene", session.CurrentScene().name},
                                           {"frames", writer.Frames()},
                                           {"out", options.out},
                                           {"width", size.width},
                                           {"height", size.height},
                                           {"backend", writer.Recorder().BackendName()},
                                           {"gl", writer.Recorder().GlDescription()},
                                           {"time", session.System().Time()},
                                           {"wall_seconds", watch.Seconds()},
                                           {"status", session.System().Trouble() ? "unstable" : "ok"},
                                           {"drawing_seconds", writer.Recorder().DrawingSeconds()},
                                           {"writing_seconds", writer.Recorder().WritingSeconds()}};
    fmt::print("{}\n", report.dump(2));
  } else if (!options.common.quiet) {
    fmt::print("{} frames of {} pixels in {} ({}, {:.1f} s): {} ...\n", writer.Frames(), options.size, options.out,
               writer.Recorder().BackendName(), watch.Seconds(), FrameFile(options.out, 0).string());
  }
  if (const auto& trouble = session.System().Trouble()) {
    fmt::print(stderr, "sphlab: unstable: {}\n", trouble->Message());
    return ExitCode::kUnstable;
  }
  return Interrupted() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace sph
