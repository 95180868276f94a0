// Watches a running system: do energy, volume and rest keep what its scene promises?
#pragma once

#include <string>
#include <vector>

#include "lab/promises.hpp"
#include "lab/run_checks.hpp"
#include "particles/diagnostics.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

class RunWatch {
 public:
  /// Steps between two looks, and looks between two of the area that particles fill.
  static constexpr long kStepsApart = 10;
  static constexpr long kLooksApart = 10;

  /// The system is at the start of the scene, and both must live as long.
  RunWatch(const Scene& scene, ParticleSystemSPH& system);

  /// To be called every kStepsApart steps.
  void Look();
  /// To be called when scene or system were changed by other means than steps: energies and volumes of before are not
  /// compared with those from here on.
  void Disturbed();
  /// A step broke down.
  void BrokeDown(const std::string& how);
  /// The first flaw of the run so far; empty if all promises are kept. To be called last.
  std::string Flaw() const;
  const Promises& Promised() const { return promises_; }

 private:
  void Keep(const std::string& flaw);
  EnergyBudget NewBudget() const;
  VolumeCheck NewVolume() const;
  bool IsSqueezed() const;
  bool WallsMove() const;
  double StoredEnergy(const Diagnostics& d) const;
  void AddWork(const Diagnostics& d);
  void LookAtVolume();
  Box Bounds() const;

  const Scene& scene_;
  ParticleSystemSPH& system_;
  Promises promises_;
  EnergyBudget energy_;
  VolumeCheck volume_;
  RestCheck rest_;
  bool disturbed_ = false;
  bool step_is_kept_ = true;
  bool is_a_sheet_ = false;  // of a liquid
  long looks_ = 0;
  double work_ = 0;  // [J/m], of gravity along periods
  double power_ = 0, time_ = 0;
  std::string flaw_;
};

}  // namespace sph
