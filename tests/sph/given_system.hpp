// Systems whose start a test chooses, and that it can turn round.
#pragma once

#include <functional>

#include "sph/clouds.hpp"
#include "sph/delta.hpp"
#include "sph/turning.hpp"

namespace sph {

/// The paper's system with particles given one by one.
class GivenSystem : public Turning<ParticleSystemSPH> {
 public:
  GivenSystem(const Parameters& base, const ParametersSPH& sph, Cloud start)
      : Turning(base, sph), start_(std::move(start)) {
    Reset();
  }

 protected:
  void InitialPositions() override {
    for (std::size_t i = 0; i < start_.Size(); ++i) {
      particles_.Add({start_.x[i], start_.y[i]}, {start_.vx[i], start_.vy[i]}, start_.mass[i]);
    }
  }

 private:
  Cloud start_;
};

/// A liquid whose particles a test sets in motion, and can turn round.
class GivenLiquid : public Turning<Delta> {
 public:
  GivenLiquid(const Parameters& base, const ParametersSPH& sph, std::function<Vec2(Vec2)> velocity)
      : Turning(base, sph), velocity_(std::move(velocity)) {
    Reset();
  }

 protected:
  void InitialPositions() override {
    Delta::InitialPositions();
    Particles& p = particles_;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const Vec2 v = velocity_(p.Position(i));
      p.vx[i] = p.vx_prev[i] = v.x;
      p.vy[i] = p.vy_prev[i] = v.y;
    }
  }

 private:
  std::function<Vec2(Vec2)> velocity_;
};

/// The particles of a system at its current time, as a cloud.
inline Cloud CloudOf(const ParticleSystem& system) {
  const Particles& p = system.State();
  return {"", p.x, p.y, p.vx, p.vy, p.mass};
}

/// Parameters of a system that only has to hold particles: no forces, no walls, a step of 1 ms, leapfrog.
inline Parameters NoForces() {
  Parameters base;
  base.particle_mass = 1;
  base.time_step = 1e-3;
  base.fluid.particles = 1;
  base.fluid.region.box = {0, 0, 1, 1};
  return base;
}

}  // namespace sph
