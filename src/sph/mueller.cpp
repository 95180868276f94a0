#include "sph/mueller.hpp"

#include <algorithm>

namespace sph {

Mueller::Mueller(const Parameters& base, const ParametersSPH& sph) : ParticleSystemSPH(base, sph) {
  if (sph.precision == Precision::kDouble) arrays_ = Arrays<double>();
}

void Mueller::ResizeArrays(std::size_t n) {
  ParticleSystemSPH::ResizeArrays(n);
  std::visit(
      [n](auto& arrays) {
        for (auto* values : {&arrays.volume, &arrays.pressure, &arrays.vx, &arrays.vy}) values->resize(n + kPadding);
      },
      arrays_);
}

void Mueller::ComputeDensities(ListBlock& block) {
  std::visit([&](auto& fluid) { ComputePoly6Density(InputOf(fluid), block, fluid.density.data()); }, fluid_);
}

void Mueller::PrepareInteraction(std::size_t first, std::size_t last) {
  const Particles& p = particles_;
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid, const auto& equation_of_state) {
        auto& arrays = std::get<Arrays<Real>>(arrays_);
        for (std::size_t i = first; i < last; ++i) {
          arrays.volume[i] = static_cast<Real>(p.mass[i]) / fluid.density[i];
          arrays.pressure[i] = equation_of_state.Pressure(fluid.density[i]);
          arrays.vx[i] = static_cast<Real>(p.vx[i]);
          arrays.vy[i] = static_cast<Real>(p.vy[i]);
        }
      },
      fluid_, parameters_sph.equation_of_state);
}

void Mueller::PrepareImages() {
  std::visit(
      [&](auto& arrays) {
        for (auto* values : {&arrays.volume, &arrays.pressure, &arrays.vx, &arrays.vy}) CopyToImages(*values);
      },
      arrays_);
}

void Mueller::AddSpatialInteraction(const ListBlock& block) {
  Particles& p = particles_;
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid) {
        const auto& arrays = std::get<Arrays<Real>>(arrays_);
        const MuellerInput<Real> input{arrays.volume.data(),
                                       arrays.pressure.data(),
                                       fluid.density.data(),
                                       arrays.vx.data(),
                                       arrays.vy.data(),
                                       parameters_sph.viscosity,
                                       parameters_sph.mueller_published};
        AddMuellerForces(InputOf(fluid), input, block, p.ax.data(), p.ay.data());
        if (!parameters_sph.mueller_published) return;
        const auto [first, last] = ParticlesOf(block);
        for (std::size_t i = first; i < last; ++i) {
          const double rho = fluid.density[i];
          const double excess = p.mass[i] / (rho * rho) - 1;  // gravity itself is added to every system
          p.ax[i] += excess * parameters.gravity.x;
          p.ay[i] += excess * parameters.gravity.y;
        }
      },
      fluid_);
}

std::vector<StepLimit> Mueller::StepLimits() const {
  std::vector<StepLimit> limits = ParticleSystemSPH::StepLimits();
  const auto density = Density();
  if (parameters_sph.viscosity > 0 && !density.empty()) {
    const double least = *std::min_element(density.begin(), density.end());
    limits.push_back({"viscosity", ViscousStep(parameters_sph.viscosity, least, Support()), LimitKind::kDecaying});
  }
  return limits;
}

std::size_t Mueller::Bytes() const {
  return ParticleSystemSPH::Bytes() +
         std::visit(
             []<typename Real>(const Arrays<Real>& arrays) { return sizeof(Real) * 4 * arrays.volume.capacity(); },
             arrays_);
}

std::vector<PassPlan> Mueller::Plan() const {
  std::vector<PassPlan> plan = ParticleSystemSPH::Plan();
  const bool viscous = parameters_sph.viscosity != 0;
  for (PassPlan& pass : plan) {
    if (pass.name == "density") pass.reason = "Poly6 density and ideal-gas pressure";
    if (pass.name != "pressure") continue;
    pass.reason = viscous ? "Spiky pressure and viscosity in one pass" : "Spiky pressure; viscosity is 0 and left out";
  }
  return plan;
}

}  // namespace sph
