// The tutorial's solver: Mueller's interactive SPH in the plane.
#pragma once

#include "sph/particle_system_sph.hpp"

namespace sph {

/// Poly6 density, Spiky pressure, Viscosity kernel [Mueller, Charypar & Gross 2003]. `smoothing_length` is the support
/// radius. With parameters_sph.mueller_published it repeats the tutorial's program as first published:
/// PublishedSpikySlope, and gravity multiplied by m/rho^2.
class Mueller final : public ParticleSystemSPH {
 public:
  using ParticleSystemSPH::ParticleSystemSPH;

  std::string KernelName() const override { return "Poly6, Spiky, Viscosity"; }
  double Support() const override { return parameters_sph.smoothing_length; }
  std::vector<PassPlan> Plan() const override;

 protected:
  void ComputeAccelerations() override;
  void ComputeDensities(const NeighbourBlock& block) override;
  void AddSpatialInteraction() override;
};

}  // namespace sph
