#include "commands/run.hpp"

#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "commands/interrupt.hpp"
#include "commands/messages.hpp"
#include "commands/report.hpp"
#include "commands/run_state.hpp"
#include "commands/time_series.hpp"
#include "window/key_script.hpp"

namespace sph {
namespace {

/// "t = 3.1 s of 20 s" on a terminal, a few times a second.
class Progress {
 public:
  explicit Progress(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (wanted_) fmt::print(stderr, "\r\033[K");
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Show(double time, double until) {
    if (!wanted_ || watch_.Seconds() < 0.2) return;
    watch_.Restart();
    fmt::print(stderr, "\rt = {:.4g} s of {:.4g} s\033[K", time, until);
    std::fflush(stderr);
  }

 private:
  bool wanted_;
  Stopwatch watch_;
};

/// Saves a run now and then, if it is to be saved at all.
class Saver {
 public:
  Saver(const RunOptions& options, const SceneRequest& request, RunState run)
      : path_(options.checkpoint), every_(options.checkpoint_every), request_(request), run_(run) {
    Save();  // so that a file that cannot be written is known before hours have gone into the run
  }

  void Save() {
    if (path_.empty()) return;
    run_.series.Write();
    SaveRun(path_, request_, run_);
    since_.Restart();
  }
  void SaveIfDue() {
    if (since_.Seconds() >= every_) Save();
  }

 private:
  std::string path_;
  double every_;  // [s]
  SceneRequest request_;
  RunState run_;
  Stopwatch since_;
};

ExitCode Report(const RunOptions& options, const Session& session, double wall_seconds) {
  const auto report = ReportRun(session, wall_seconds);
  if (options.common.json) {
    fmt::print("{}\n", report.dump(2));
  } else if (!options.common.quiet) {
    fmt::print("{}", DescribeRun(report));
  }
  if (const auto& trouble = session.System().Trouble()) {
    fmt::print(stderr, "sphlab: unstable: {}\n", trouble->Message());
    return ExitCode::kUnstable;
  }
  return Interrupted() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace

ExitCode RunScene(const RunOptions& options) {
  CatchInterrupts();
  SceneRequest request = options.common.request;
  if (!options.restart.empty()) request = RequestToGoOnWith(options.restart, request, options.scene_given);
  Session session(request);
  NotePlacement(session.CurrentScene(), options.common.quiet);
  KeyScript keys(options.common.keys, session.CurrentScene());
  TimeSeries series(options.csv, options.every);
  const RunState run{session, keys, series};
  if (!options.restart.empty()) RestoreRun(options.restart, run);
  Saver saver(options, request, run);
  const double until = options.until.value_or(session.CurrentScene().until);
  constexpr double kRoundOff = 1e-6;  // of a time step: the sum of the steps is not exact
  Progress progress(!options.common.quiet);
  const auto finished = [&] {
    const ParticleSystemSPH& system = session.System();
    if (options.steps) return system.Steps() >= *options.steps;
    return system.Time() >= until - kRoundOff * system.parameters.time_step;
  };
  const Stopwatch watch;
  while (!finished() && !session.System().Trouble() && !Interrupted()) {
    keys.Play(session);
    PassOnMessage(session, options.common.quiet);
    if (session.save_requested) fmt::print(stderr, "s saves nothing in `run`: use `sphlab render`\n");
    session.save_requested = false;
    if (session.quit_requested) break;
    series.Sample(session.System());
    const long before = session.System().Steps();
    if (!session.StepUnlessPaused()) break;  // no later key can be reached
    if (session.System().Steps() <= before) series.Rewind(session.System());
    progress.Show(session.System().Time(), until);
    if (!session.System().Trouble()) saver.SaveIfDue();
  }
  const double wall_seconds = watch.Seconds();
  PassOnMessage(session, options.common.quiet);
  if (!session.System().Trouble()) {  // else the last good state stays saved
    saver.Save();
    const long before = session.System().Steps();
    session.ComputeFields();
    if (session.System().Steps() < before) series.Rewind(session.System());
  }
  series.Finish(session.System());
  return Report(options, session, wall_seconds);
}

}  // namespace sph
