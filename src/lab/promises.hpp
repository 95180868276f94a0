// What may be asked of a run: which conservation laws a scene's method promises to keep.
#pragma once

#include "scenes/scene.hpp"

namespace sph {

struct Promises {
  /// Kinetic, internal and potential energy together do not grow, but by what is put in, see EnergyBudget. Pressure
  /// derives from an internal energy in solver paper and, but for what its corrections leave, in delta; solver mueller
  /// has forces that are no gradient of an energy. (A liquid's pressure knows nothing of places at the start: random
  /// ones may have their centre of mass too low.)
  bool energy = false;
  /// Liquids of delta: the volume, by densities and by places, stays.
  bool volume = false;
  /// The start is an equilibrium, and nothing moves it.
  bool rest = false;
  /// The fluid is slow beside its sound, and no step that keeps its limits breaks down. (Where particles lie on each
  /// other at random and move at once, their sums say nothing of the flow.)
  bool calm = false;
};

/// Of a scene, whose system is at its start.
Promises PromisesOf(const Scene& scene, const ParticleSystemSPH& system);

/// The greatest speed of the walls along themselves where the fluid sticks to them [m/s].
double FastestSlide(const Scene& scene);

}  // namespace sph
