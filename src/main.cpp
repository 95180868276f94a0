// The command line.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "base/error.hpp"
#include "base/instruction_set.hpp"
#include "base/nearest_name.hpp"
#include "commands/bench.hpp"
#include "commands/command_line.hpp"
#include "commands/figures.hpp"
#include "commands/interrupt.hpp"
#include "commands/listing.hpp"
#include "commands/messages.hpp"
#include "commands/render.hpp"
#include "commands/run.hpp"
#include "commands/stress.hpp"
#include "commands/verify.hpp"
#include "scenes/catalogue.hpp"
#include "window/window.hpp"

namespace sph {
namespace {

/// What one call of the program is: the options as read, and the command that they are for.
class CommandLine {
 public:
  CommandLine() {
    app_.set_help_flag("--help", "what there is");
    app_.get_formatter()->column_width(34);
    const std::string exit_codes =
        "Exit codes: 0 done, 1 run-time or file trouble, 2 wrong command line or scene, 3 unstable simulation,\n"
        "130 interrupted.";
    app_.footer(exit_codes);  // the commands take it over
    AddSceneOptions(app_, window_);
    AddRender();
    AddRun();
    AddScenes();
    AddInfo();
    AddFigures();
    AddVerify();
    AddBench();
    AddStress();
    app_.footer("Without a command: the scene in a window. `sphlab COMMAND --help` says what a command takes.\n" +
                exit_codes);
  }

  ExitCode Run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return ExplainParseError(error);
    }
    if (!chosen_) return OpenWindow();
    CheckOrder();
    return chosen_();
  }

 private:
  /// A subcommand that does `work` after parsing.
  template <typename Work>
  CLI::App* Add(const std::string& name, const std::string& what, Work work) {
    CLI::App* command = app_.add_subcommand(name, what);
    command->callback([this, work] { chosen_ = work; });
    return command;
  }

  void AddRender() {
    CLI::App* command =
        Add("render", "PNG frames of a scene, no display needed", [this] { return RenderScene(render_); });
    AddSceneOptions(*command, render_.common.request);
    AddOutputOptions(*command, render_.common);
    command->add_option("--out", render_.out, "folder of the frames")->required();
    command->add_option("--frames", render_.frames, "how many at most; default: up to --until")
        ->check(WholeNumber(1, 100'000'000));
    command->add_option("--fps", render_.fps, "frames per simulated second")
        ->check(FinitePositive())
        ->capture_default_str();
    command->add_option("--until", render_.until, "simulated end [s]; default: the scene's")->check(FinitePositive());
    command->add_option("--size", render_.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--backend", render_.backend, "auto, osmesa or egl")->capture_default_str();
    AddKeysOption(*command, render_.common);
  }

  void AddRun() {
    CLI::App* command = Add("run", "a scene without a picture; no GL is loaded", [this] {
      run_.scene_given = run_scene_->count() > 0;
      return RunScene(run_);
    });
    AddSceneOptions(*command, run_.common.request);
    AddOutputOptions(*command, run_.common);
    auto* until =
        command->add_option("--until", run_.until, "simulated end [s]; default: the scene's")->check(FinitePositive());
    command->add_option("--steps", run_.steps, "number of steps")
        ->check(WholeNumber(0, 1'000'000'000'000))
        ->excludes(until);
    auto* csv = command->add_option("--csv", run_.csv, "file of energies, momenta, ... against time");
    command->add_option("--every", run_.every, "simulated time between the rows of --csv [s]")
        ->check(FinitePositive())
        ->needs(csv);
    command->add_option("--checkpoint", run_.checkpoint, "file that the run is saved in, to go on from")
        ->check(
            CLI::Validator([](std::string& name) { return name.empty() ? "a file's name" : std::string(); }, "FILE"));
    command->add_option("--checkpoint-every", run_.checkpoint_every, "wall time between two savings [s]")
        ->check(FinitePositive())
        ->capture_default_str()
        ->needs("--checkpoint");
    command->add_option("--restart", run_.restart, "checkpoint to go on from");
    AddKeysOption(*command, run_.common);
    run_scene_ = command->get_option("SCENE");
  }

  void AddScenes() {
    CLI::App* command = Add("scenes", "the scenes, one a line", [this] {
      ListScenes(json_);
      return ExitCode::kDone;
    });
    command->add_flag("--json", json_, "an array of {name, title, solver, particles}");
  }

  void AddInfo() {
    CLI::App* command = Add("info", "program, GL back-ends, processor; for a scene, its plan of passes", [this] {
      if (info_scene_->count() == 0) {
        DescribeProgram(json_);
      } else {
        DescribeScene(info_, json_);
      }
      return ExitCode::kDone;
    });
    AddSceneOptions(*command, info_);
    info_scene_ = command->get_option("SCENE");
    command->add_flag("--json", json_, "one object");
  }

  void AddFigures() {
    CLI::App* command = Add("figures", "figures like the paper's 1, 2 and 3", [this] {
      MakeFigures(figures_out_);
      return ExitCode::kDone;
    });
    command->add_option("--out", figures_out_, "folder of figure1.png, figure2.png, figure3.png")->required();
  }

  void AddVerify() {
    CLI::App* command = Add("verify", "accuracy against exact solutions", [this] { return Verify(verify_); });
    command->add_option("CASE", verify_.cases, "names of cases; default: all that are quick");
    command->add_flag("--all", verify_.all, "the long ones, too, and more particles");
    command->add_option("--threads", verify_.threads, "0: as many as there are processors")
        ->check(WholeNumber(0, 4096));
    command->add_flag("--json", verify_.json,
                      "an array of {case, solver, particles, metric, kind, value, bar, holds, order, ladder, ...}");
  }

  void AddBench() {
    CLI::App* command =
        Add("bench", "run time against error of the cases of verify; speed", [this] { return Bench(bench_); });
    command->add_option("CASE", bench_.cases, "cases of verify, default all; speed: what a particle and step costs");
    command->add_option("--out", bench_.out, "folder of the tables, CSV files and plots")->required();
    command->add_flag("--quick", bench_.quick, "small systems only");
    command->add_flag("--peers", bench_.peers, "PySPH beside the cases that it has examples of");
    command->add_option("--longest", bench_.longest, "a run of a case that would take longer is left out [s]")
        ->check(FinitePositive())
        ->capture_default_str();
    command->add_option("--threads", bench_.threads, "of the cases' runs; of one its processor time is taken")
        ->check(WholeNumber(1, 1024))
        ->capture_default_str();
  }

  void AddStress() {
    CLI::App* command = Add("stress", "numerical stability: limits, starts, sizes, rough handling, random scenes",
                            [this] { return Stress(stress_); });
    command->add_option("TEST", stress_.tests, "names of tests; default: all, some twenty minutes");
    command->add_option("--out", stress_.out, "folder of maps and plots (PNG) and their numbers (CSV)");
    command->add_flag("--quick", stress_.options.quick, "small systems and short runs, about half a minute");
    command->add_option("--count", stress_.options.count, "of starts or random scenes")
        ->check(WholeNumber(1, 100'000'000));
    command->add_option("--seed", stress_.options.seed, "of the first of them; default: 1, of random scenes the day's");
    command->add_option("--threads", stress_.options.threads, "0: as many as there are processors")
        ->check(WholeNumber(0, 4096));
    command->add_flag("--json", stress_.json,
                      "an array of {test, what, metric, value, bar, holds, note, wall_seconds}");
  }

  /// What stands before a command is read as the window's, and would do nothing.
  void CheckOrder() const {
    for (const CLI::Option* option : app_.get_options()) {
      if (option->count() == 0) continue;
      throw UsageError("{} stands before the command '{}': it goes after it", option->get_name(),
                       app_.get_subcommands().front()->get_name());
    }
  }

  /// " Did you mean 'render'?" for a scene that is none, but nearly a command.
  std::string CommandMeant() const {
    const std::string& scene = window_.scene;
    const auto scenes = SceneNames();
    const bool known = scene.ends_with(".toml") || std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
    if (known || !NearestName(scene, scenes).empty()) return {};
    std::vector<std::string> commands;
    for (const CLI::App* command : app_.get_subcommands({})) commands.push_back(command->get_name());
    return DidYouMean(scene, commands);
  }

  ExitCode OpenWindow() const {
    if (const std::string meant = CommandMeant(); !meant.empty()) {
      throw UsageError("unknown command or scene '{}'.{}", window_.scene, meant);
    }
    CatchInterrupts();
    NotePlacement(LoadScene(window_), false);
    return RunWindow(window_, &Interrupted);
  }

  /// --help prints to stdout and is no error; everything else is a message with the nearest option.
  ExitCode ExplainParseError(const CLI::ParseError& error) const {
    if (error.get_exit_code() == 0) {
      app_.exit(error);
      return ExitCode::kDone;
    }
    const CLI::App* command = &app_;
    for (const CLI::App* chosen : app_.get_subcommands()) command = chosen;
    std::string message = error.what();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
      if (const std::string meant = CommandMeant(); command == &app_ && !meant.empty()) {
        throw UsageError("unknown command or scene '{}'.{}", window_.scene, meant);
      }
      std::vector<std::string> names;
      for (const CLI::Option* option : command->get_options()) names.push_back("--" + option->get_single_name());
      const std::vector<std::string> extras = app_.remaining(true);
      message = "not expected:";
      for (const std::string& extra : extras) message += " '" + extra + "'";
      if (!extras.empty()) message += "." + DidYouMean(extras.front().substr(0, extras.front().find('=')), names);
    }
    fmt::print(stderr, "sphlab: {}\n`sphlab {}--help` says what is accepted.\n", message,
               command == &app_ ? "" : command->get_name() + " ");
    return ExitCode::kUsage;
  }

  CLI::App app_{"sphlab, the SPH laboratory: fluids made of particles, while they move", "sphlab"};
  std::function<ExitCode()> chosen_;
  SceneRequest window_;
  RenderOptions render_;
  RunOptions run_;
  CLI::Option* run_scene_ = nullptr;
  SceneRequest info_;
  CLI::Option* info_scene_ = nullptr;
  std::string figures_out_;
  BenchOptions bench_;
  VerifyOptions verify_;
  StressCommand stress_;
  bool json_ = false;
};

/// Results that a full disk has swallowed are no success.
void CheckThatResultsAreOut() {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  throw TroubleError("cannot write the results to standard output: {}", std::strerror(errno));
}

/// Threads that wait for each other spin for a short while only: on a machine that others use, one that spins keeps the
/// one that it waits for from running. OpenMP's library reads this when it is loaded, before main, hence the second
/// start; should that fail, the program only runs slower beside others.
void WaitPolitely(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  constexpr const char* kSpins = "10000";  // some 10 microseconds
  if (setenv("GOMP_SPINCOUNT", kSpins, 1) == 0) execv("/proc/self/exe", argv);
}

int Main(int argc, char** argv) {
  WaitPolitely(argv);
  try {
    if (const char* set = std::getenv("SPHLAB_SIMD")) UseInstructionSet(set, "SPHLAB_SIMD");
    const ExitCode code = CommandLine().Run(argc, argv);
    CheckThatResultsAreOut();
    return static_cast<int>(code);
  } catch (const Error& error) {
    fmt::print(stderr, "sphlab: {}\n", error.what());
    return static_cast<int>(error.Code());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "sphlab: out of memory\n");
    return static_cast<int>(ExitCode::kTrouble);
  } catch (const std::exception& error) {
    fmt::print(stderr, "sphlab: {}\n", error.what());
    return static_cast<int>(ExitCode::kTrouble);
  }
}

}  // namespace
}  // namespace sph

int main(int argc, char** argv) { return sph::Main(argc, argv); }
