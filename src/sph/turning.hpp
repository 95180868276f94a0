// A system that can go back the way it came: what leapfrog without damping promises.
#pragma once

#include "sph/particle_system_sph.hpp"

namespace sph {

/// `System` is a ParticleSystemSPH, with its constructors.
template <typename System>
class Turning : public System {
 public:
  using System::System;

  /// From here on the undamped leapfrog goes back: the velocity half a step "before" is minus the one that would have
  /// come half a step after.
  void TurnRound() {
    this->ComputeAccelerations();
    Particles& p = this->particles_;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      p.vx_prev[i] = p.vx[i] = -(p.vx_prev[i] + this->parameters.time_step * p.ax[i]);
      p.vy_prev[i] = p.vy[i] = -(p.vy_prev[i] + this->parameters.time_step * p.ay[i]);
    }
  }
};

}  // namespace sph
