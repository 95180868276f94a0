#include "headless/frame_recorder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "base/random.hpp"
#include "headless/frame_renderer.hpp"
#include "io/png.hpp"
#include "io/scratch.hpp"
#include "io/trouble.hpp"

namespace sph {
namespace {

constexpr Box kRegion = {-1, -1, 1, 1};

/// Another picture for every number.
void DrawNumbered(int number, Canvas& canvas) {
  Random random(static_cast<std::uint64_t>(number));
  std::vector<double> x, y, values;
  for (int i = 0; i < 500 + 100 * number; ++i) {
    x.push_back(random.Uniform(-1.2, 1.2));
    y.push_back(random.Uniform(-0.9, 0.3));
    values.push_back(random.Uniform());
  }
  const bool black = canvas.WantedColouring() == Colouring::kBlackDisks;
  canvas.DrawDisks(x, y, 0.01 + 0.01 * number, black ? std::span<const double>() : values);
  canvas.DrawWall({-0.9, -0.9}, {0.9, -0.9 + 0.1 * number});
}

Colouring ColouringOf(int number) { return number % 2 == 0 ? Colouring::kBlackDisks : Colouring::kSpeed; }

std::filesystem::path FileOf(const ScratchDirectory& folder, int number) {
  return folder.Path() / fmt::format("{}.png", number);
}

void RecordNumbered(FrameRecorder& recorder, const ScratchDirectory& folder, int number) {
  recorder.Record(FileOf(folder, number), kRegion, ColouringOf(number),
                  [&](Canvas& canvas) { DrawNumbered(number, canvas); });
}

TEST(FrameRecorder, WritesTheFilesThatDrawingThemAtOnceGives) {
  constexpr int kFrames = 12;
  for (const Backend backend : {Backend::kOsmesa, Backend::kEgl}) {
    const ScratchDirectory recorded, drawn;
    FrameRecorder recorder(backend, 160, 120);
    FrameRenderer renderer(backend, 160, 120);
    EXPECT_EQ(recorder.BackendName(), renderer.BackendName());
    EXPECT_EQ(recorder.GlDescription(), renderer.GlDescription());
    for (int i = 0; i < kFrames; ++i) RecordNumbered(recorder, recorded, i);
    recorder.Finish();
    EXPECT_EQ(recorded.Count(), kFrames);
    for (int i = 0; i < kFrames; ++i) {
      WritePng(FileOf(drawn, i),
               renderer.Render(kRegion, ColouringOf(i), [&](Canvas& canvas) { DrawNumbered(i, canvas); }));
      EXPECT_TRUE(Contents(FileOf(recorded, i)) == Contents(FileOf(drawn, i))) << "frame " << i;
    }
    EXPECT_GT(recorder.DrawingSeconds(), 0);
    EXPECT_GT(recorder.WritingSeconds(), 0);
  }
}

TEST(FrameRecorder, FinishesWhatWasRecordedWhenItGoes) {
  const ScratchDirectory folder;
  {
    FrameRecorder recorder(Backend::kAuto, 100, 100);
    for (int i = 0; i < 3; ++i) RecordNumbered(recorder, folder, i);
  }
  EXPECT_EQ(folder.Count(), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(ReadPng(FileOf(folder, i)).width, 100);
}

TEST(FrameRecorder, SaysAtTheEndThatTheLastFileCouldNotBeWritten) {
  const ScratchDirectory folder;
  FrameRecorder recorder(Backend::kAuto, 100, 100);
  recorder.Record(folder.Path() / "missing/0.png", kRegion, Colouring::kBlackDisks,
                  [](Canvas& canvas) { DrawNumbered(0, canvas); });
  EXPECT_TRUE(Complains([&] { recorder.Finish(); }, {"missing/0.png", "No such file"}));
  EXPECT_EQ(folder.Count(), 0);
}

TEST(FrameRecorder, StopsWhoRecordsOnAfterAFailure) {
  const ScratchDirectory folder;
  FrameRecorder recorder(Backend::kAuto, 100, 100);
  RecordNumbered(recorder, folder, 0);
  recorder.Record(folder.Path() / "missing/1.png", kRegion, Colouring::kBlackDisks,
                  [](Canvas& canvas) { DrawNumbered(1, canvas); });
  const auto go_on = [&] {
    for (int i = 2; i < 1000; ++i) RecordNumbered(recorder, folder, i);
  };
  EXPECT_TRUE(Complains(go_on, {"missing/1.png"}));
  EXPECT_TRUE(Complains([&] { recorder.Finish(); }, {"missing/1.png"}));
  EXPECT_EQ(folder.Count(), 1) << "the one before is whole, and none came after";
  EXPECT_EQ(ReadPng(FileOf(folder, 0)).width, 100);
}

TEST(FrameRecorder, LeavesOutAFrameWhoseDrawingFailed) {
  const ScratchDirectory folder;
  FrameRecorder recorder(Backend::kAuto, 100, 100);
  const auto fail = [](Canvas& canvas) {
    DrawNumbered(3, canvas);
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(recorder.Record(FileOf(folder, 7), kRegion, Colouring::kSpeed, fail), std::runtime_error);
  RecordNumbered(recorder, folder, 0);
  recorder.Finish();
  EXPECT_EQ(folder.Count(), 1);
  FrameRenderer renderer(Backend::kAuto, 100, 100);
  EXPECT_EQ(ReadPng(FileOf(folder, 0)),
            renderer.Render(kRegion, ColouringOf(0), [](Canvas& canvas) { DrawNumbered(0, canvas); }));
}

TEST(FrameRecorder, SaysAtOnceThatItCannotDraw) {
  EXPECT_TRUE(Complains(
      [] {
        FrameRecorder(Backend::kOsmesa, 100, 100, {{"libsphlab-none.so"}, {}});
      },
      {"libsphlab-none.so", "libosmesa6"}));
  EXPECT_TRUE(Complains([] { FrameRecorder(Backend::kAuto, 1000000, 100); }, {"1000000 x 100"}));
}

}  // namespace
}  // namespace sph
