#include "commands/figures.hpp"

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "commands/montage.hpp"
#include "headless/frame_renderer.hpp"
#include "io/output_directory.hpp"
#include "io/png.hpp"
#include "lab/toy_star_profile.hpp"
#include "scenes/build.hpp"
#include "window/key_script.hpp"

namespace sph {
namespace {

constexpr int kPanelSize = 360;  // [pixels]
constexpr int kGap = 2;          // [pixels]

struct Snapshot {
  double time = 0;  // [s]
  std::string what;
};

void RunUntil(Session& session, KeyScript& keys, double time) {
  constexpr double kRoundOff = 1e-6;  // of a step
  while (session.System().Time() < time - kRoundOff * session.System().parameters.time_step) {
    keys.Play(session);
    session.Step();
    if (const auto& trouble = session.System().Trouble()) {
      throw TroubleError("figures: the scene {} broke down: {}", session.CurrentScene().name, trouble->Message());
    }
  }
  keys.Play(session);
}

/// The scene at each of the times, in rows of `columns` panels.
Image Strip(const std::string& scene, const std::string& keys, std::span<const Snapshot> snapshots, int columns) {
  SceneRequest request;
  request.scene = scene;
  Session session(request);
  KeyScript script = keys.empty() ? KeyScript() : KeyScript(keys, session.CurrentScene());
  FrameRenderer renderer(Backend::kAuto, kPanelSize, kPanelSize);
  std::vector<Image> panels;
  for (const Snapshot& snapshot : snapshots) {
    RunUntil(session, script, snapshot.time);
    panels.push_back(renderer.Render(
        InitialView(session.CurrentScene()), Colouring::kBlackDisks,
        [&](Canvas& canvas) { session.System().Draw(canvas); },
        {fmt::format("t = {:.1f} s{}{}", session.System().Time(), snapshot.what.empty() ? "" : ": ", snapshot.what),
         ""}));
  }
  return JoinPanels(panels, columns, kGap);
}

Image DamBreak() {
  const std::vector<Snapshot> snapshots = {{3.9, "settled"},         {4.1, "the dam is gone"}, {4.4, "running"},
                                           {5.0, "at the far wall"}, {5.6, "thrown back"},     {6.2, "sloshing"}};
  return Strip("dam-break", "4:d", snapshots, 3);
}

Image OrderingOfTheStar() {
  const std::vector<Snapshot> snapshots = {{0, "random"},         {0.1, "pushed apart"}, {0.5, "swinging out"},
                                           {1.5, "falling back"}, {5, "ordering"},       {20, "ordered"}};
  return Strip("toy-star", "", snapshots, 3);
}

Image DensityOfTheStar() {
  SceneRequest request;
  request.scene = "toy-star";
  request.particles = 3000;
  Session session(request);
  KeyScript no_keys;
  RunUntil(session, no_keys, session.CurrentScene().until);
  session.System().ComputeFields();
  return Draw(ToyStarProfile(session.System(), *StarOf(session.CurrentScene())));
}

}  // namespace

void MakeFigures(const std::filesystem::path& out) {
  PrepareOutputDirectory(out);
  WritePng(out / "figure1.png", DamBreak());
  WritePng(out / "figure2.png", OrderingOfTheStar());
  WritePng(out / "figure3.png", DensityOfTheStar());
}

}  // namespace sph
