// The tutorial's solver: Mueller's interactive SPH in the plane.
#pragma once

#include "sph/particle_system_sph.hpp"

namespace sph {

/// A step that explicit viscosity mu [Pa s] is just stable with [s], at a density [kg/m^3] and a support radius [m]: in
/// proportion to the square of the spacing, where sound allows its first power.
inline double ViscousStep(double mu, double density, double support) {
  const double h = 0.5 * support;
  return 0.3 * h * h * density / mu;
}

/// Poly6 density, Spiky pressure, Viscosity kernel [Mueller, Charypar & Gross 2003]. `smoothing_length` is the support
/// radius. With parameters_sph.mueller_published it repeats the tutorial's program as first published: see
/// AddMuellerForces for its kernel gradient; its gravity is multiplied by m/rho^2.
class Mueller final : public ParticleSystemSPH {
 public:
  Mueller(const Parameters& base, const ParametersSPH& sph);

  std::string KernelName() const override { return "Poly6, Spiky, Viscosity"; }
  double Support() const override { return parameters_sph.smoothing_length; }
  std::vector<PassPlan> Plan() const override;
  std::vector<StepLimit> StepLimits() const override;
  std::size_t Bytes() const override;

 protected:
  void ResizeArrays(std::size_t n) override;
  void ComputeDensities(ListBlock& block) override;
  void PrepareInteraction(std::size_t first, std::size_t last) override;
  void PrepareImages() override;
  void AddSpatialInteraction(const ListBlock& block) override;

 private:
  template <typename Real>
  struct Arrays {
    std::vector<Real> volume;    // m/rho [m^2]
    std::vector<Real> pressure;  // [Pa]
    std::vector<Real> vx, vy;    // [m/s]
  };
  std::variant<Arrays<float>, Arrays<double>> arrays_;  // of the same precision as fluid_
};

}  // namespace sph
