// What a person at the keyboard has in hand: a scene that runs, and how it is shown. Knows no window; `run` and
// `render` use it for --keys.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "particles/canvas.hpp"
#include "particles/guard.hpp"
#include "scenes/request.hpp"
#include "sph/energy_watch.hpp"

namespace sph {

class Session {
 public:
  explicit Session(SceneRequest request);

  ParticleSystemSPH& System() { return *system_; }
  const ParticleSystemSPH& System() const { return *system_; }
  const Scene& CurrentScene() const { return scene_; }
  const Guard& CurrentGuard() const { return *guard_; }

  /// All that the session's course depends on; read, it must be of the same scene files. TroubleError otherwise.
  void Transfer(Archive& archive);

  /// Advances by one step, unless the system is in trouble. Where the step breaks down, the guard goes back as often as
  /// the scene allows, and `message` says so; it also says once that energy came from nowhere.
  void Step();
  /// The same as far as the pause key allows it: a step, a single step asked for, or none.
  /// @return whether a step was made.
  bool StepUnlessPaused();
  /// Density, pressure and accelerations of the state as it is, see Guard::ComputeFields.
  void ComputeFields() { guard_->ComputeFields(); }

  // What the controls do. Each that cannot do its work leaves the reason in `message`.
  void Reset();
  void DropBlock();
  /// To the last good state, but not beyond the last key that changed something; waits there.
  void GoBack();
  /// The scene's own meaning of a key, such as d in the dam break.
  void PressSceneKey(const std::string& key);
  /// Moves the scene's arrow wall to the left (-1) or right (+1) from now on; 0 stops it.
  void MoveWall(int direction);
  /// The scene that is `offset` places further in the catalogue, or the one of that number, counted from 1.
  void GoToNextScene(int offset);
  void GoToScene(int number);
  void NextColouring();
  void ChangeSpeed(double factor);

  // View and course of events, set by the controls and read by who shows or runs the session.
  bool paused = false;
  int single_steps = 0;  ///< steps still to be made while paused
  double speed = 1;      ///< simulated seconds per second
  Colouring colouring = Colouring::kBlackDisks;
  bool show_help = false;
  bool save_requested = false;
  bool quit_requested = false;
  std::string message;  ///< the last thing that the user should know; empty when read

 private:
  void Load(const SceneRequest& request);
  void SetKey(const std::string& key, double to);
  /// What a key has changed is not undone, and its energy is accounted for.
  void Mark();

  SceneRequest request_;
  Scene start_;                        // as loaded
  Scene scene_;                        // with what keys have set since
  std::vector<std::string> set_keys_;  // by keys since then, in their order
  std::vector<double> set_to_;
  std::uint64_t fingerprint_ = 0;  // of the scene's file
  std::unique_ptr<ParticleSystemSPH> system_;
  std::optional<Guard> guard_;
  EnergyWatch energy_;
};

/// "black disks", "speed", "pressure", "density".
std::string NameOf(Colouring colouring);

}  // namespace sph
