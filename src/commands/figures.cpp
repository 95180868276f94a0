#include "commands/figures.hpp"

#include <fmt/format.h>

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

constexpr int kColumns = 3;
constexpr int kPanelWidth = 400;  // [pixels]
constexpr int kGap = 2;           // [pixels]

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

/// What of a scene's run a figure shows.
struct Strip {
  std::string scene;
  std::string keys;  // as for --keys
  Box region;        // [m]
  int panel_height = kPanelWidth;
  std::vector<Snapshot> snapshots;
};

Image Draw(const Strip& strip) {
  SceneRequest request;
  request.scene = strip.scene;
  Session session(request);
  KeyScript keys = strip.keys.empty() ? KeyScript() : KeyScript(strip.keys, session.CurrentScene());
  FrameRenderer renderer(Backend::kAuto, kPanelWidth, strip.panel_height);
  std::vector<Image> panels;
  for (const Snapshot& snapshot : strip.snapshots) {
    RunUntil(session, keys, snapshot.time);
    const Image picture =
        renderer.Render(strip.region, Colouring::kBlackDisks, [&](Canvas& canvas) { session.System().Draw(canvas); });
    panels.push_back(WithCaption(picture, fmt::format("t = {:.1f} s: {}", session.System().Time(), snapshot.what)));
  }
  return JoinPanels(panels, kColumns, kGap);
}

Image DamBreak() {
  return Draw({.scene = "dam-break",
               .keys = "4:d",
               .region = {-0.95, -0.95, 0.95, -0.3},  // the fluid is below; the walls go on
               .panel_height = 200,
               .snapshots = {{3.9, "settled"},
                             {4.1, "the dam is gone"},
                             {4.4, "running"},
                             {5.0, "at the far wall"},
                             {5.6, "thrown back"},
                             {6.2, "sloshing"}}});
}

Image OrderingOfTheStar() {
  return Draw({.scene = "toy-star",
               .keys = "",
               .region = {-0.95, -0.95, 0.95, 0.95},
               .snapshots = {{0, "random"},
                             {0.1, "pushed apart"},
                             {0.5, "swinging out"},
                             {1.5, "falling back"},
                             {5, "ordering"},
                             {20, "ordered"}}});
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
