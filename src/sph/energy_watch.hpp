// Whether a run's energy grows by more than what was put in: then it is not to be believed, however stable it looks.
#pragma once

#include <optional>
#include <string>

#include "sph/particle_system_sph.hpp"

namespace sph {

/// Compares the fluid's energy, kinetic, of gravity and central force, internal, and that of penalty walls as springs,
/// with what it was when last something put energy in. Silent where energy comes in all the time, from a wall that
/// slides or a force along what repeats, and where a part of it is not known: that of a surface under tension, and of
/// the published form of solver mueller, whose pressure has the wrong sign.
class EnergyWatch {
 public:
  /// A pass over the particles costs less than a hundredth of this many steps.
  static constexpr long kStepsApart = 128;
  /// What energy may grow by, over all that the fluid had to lose: a dozen times what any scene here gains.
  static constexpr double kTolerance = 0.05;

  /// To be called when a key changes something: what the fluid has at the next look is what it was given.
  void Forget() { reference_.reset(); }

  /// To be called before every step; looks every kStepsApart steps, and notes the energy while a wall moves.
  /// @return a warning, once; else an empty text.
  std::string Look(const ParticleSystemSPH& system);

 private:
  struct Reference {
    double time = 0;     // [s]
    double energy = 0;   // [J/m]
    double to_lose = 0;  // of it, were all at rest at the lowest place of the fluid [J/m]
  };
  static Reference Measure(const ParticleSystemSPH& system);

  std::optional<Reference> reference_;
  long next_look_ = 0;  // step
  bool warned_ = false;
};

}  // namespace sph
