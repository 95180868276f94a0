#include "sph/mueller.hpp"

#include "sph/density_summation.hpp"
#include "sph/mueller_forces.hpp"

namespace sph {

void Mueller::ComputeDensities(const NeighbourBlock& block) {
  ComputeDensity(block, Poly6(Support()), particles_.mass, density_);
}

void Mueller::AddSpatialInteraction() {
  const PhaseTimer timer(phases_, "pressure and viscosity");
  Particles& p = particles_;
  const MuellerArrays arrays{p.x, p.y, p.vx, p.vy, p.mass, density_, pressure_, p.ax, p.ay};
  const ViscosityKernel viscosity_kernel(Support());
  const double mu = parameters_sph.viscosity;
  const auto add = [&](const auto& slope) {
    ForEachBlock([&](const NeighbourBlock& block) { AddMuellerForces(block, slope, viscosity_kernel, mu, arrays); });
  };
  if (parameters_sph.mueller_published) {
    add(PublishedSpikySlope(Support()));
  } else {
    add(SpikySlope(Support()));
  }
}

void Mueller::ComputeAccelerations() {
  ParticleSystemSPH::ComputeAccelerations();
  if (!parameters_sph.mueller_published) return;
  Particles& p = particles_;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    const double excess = p.mass[i] / (density_[i] * density_[i]) - 1;  // gravity itself has been added once
    p.ax[i] += excess * parameters.gravity.x;
    p.ay[i] += excess * parameters.gravity.y;
  }
}

std::vector<PassPlan> Mueller::Plan() const {
  std::vector<PassPlan> plan = ParticleSystemSPH::Plan();
  const bool viscous = parameters_sph.viscosity != 0;
  for (PassPlan& pass : plan) {
    if (pass.name == "density") pass.reason = "neighbours, Poly6 density and ideal-gas pressure";
    if (pass.name != "pressure") continue;
    pass.name = "pressure and viscosity";
    pass.reason = viscous ? "Spiky pressure and viscosity in one pass" : "Spiky pressure; viscosity is 0 and left out";
  }
  return plan;
}

}  // namespace sph
