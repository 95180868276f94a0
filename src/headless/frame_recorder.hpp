// Frames as PNG files, drawn and written while the simulation goes on.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "headless/context.hpp"
#include "particles/canvas.hpp"

namespace sph {

/// Three threads, each a frame further: the caller's notes what is to be seen (Snapshot), the second owns the OpenGL
/// context and draws it, the third encodes and writes the file. Between two of them at most two frames wait.
class FrameRecorder {
 public:
  /// Returns when the context is there. TroubleError as for a FrameRenderer.
  FrameRecorder(Backend backend, int width, int height, const BackendLibraries& libraries = {});
  /// Finishes what has been recorded, and says nothing of what fails then.
  ~FrameRecorder();
  FrameRecorder(const FrameRecorder&) = delete;
  FrameRecorder& operator=(const FrameRecorder&) = delete;

  /// Notes what `draw` (usually ParticleSystem::Draw) draws, for the file of the picture that FrameRenderer::Render
  /// gives of it; waits if frames come faster than they are drawn and written. Files are written in this order, each
  /// whole or not at all. After a failure none is: the error is thrown here or by Finish.
  void Record(const std::filesystem::path& file, const Box& region, Colouring colouring,
              const std::function<void(Canvas&)>& draw);
  /// Returns when every file is written; throws the error if one could not be. The last call but for what follows.
  void Finish();

  /// "osmesa" or "egl", and DescribeGl.
  const std::string& BackendName() const;
  const std::string& GlDescription() const;
  /// What the two threads have spent on frames so far [s]; to be asked after Finish.
  double DrawingSeconds() const;
  double WritingSeconds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sph
