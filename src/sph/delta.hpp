// The accurate solver: smooth kernels; gas by summation, water by the continuity equation with density diffusion,
// particle shifting and tensile control.
#pragma once

#include <array>

#include "sph/delta_passes.hpp"
#include "sph/kernel_properties.hpp"
#include "sph/particle_system_sph.hpp"
#include "sph/side_velocities.hpp"
#include "sph/surface_tension.hpp"
#include "sph/wall_particles.hpp"

namespace sph {

/// delta-SPH [Antuono et al. 2010, Marrone et al. 2011] with the particle shifting of Sun et al. 2017, for liquids; for
/// gas (P = k rho^2), whose density has no reference, the paper's summation and pressure force with a Wendland kernel.
///
/// A step of a liquid has two passes over neighbours. Densities go from t - dt to t by the rates at t - dt/2, with the
/// velocities of that time: positions are put back by half a step for that pass. Then come the forces at t. As both are
/// centred, the scheme is of second order; it would be reversible if the rate did not multiply by the density of t -
/// dt. The renormalised gradient of density, which the diffusion needs, comes with the forces of the step before.
///
/// Shifting is part of that: the particles move by u dt + dr, halfway by half of both, and density changes by dr.grad
/// rho beside its rate, as it is another place's [P. N. Sun et al., Comput. Methods Appl. Mech. Eng. 348 (2019) 912]. A
/// shift that is put behind the step instead is a first-order error at every step, heard as sound.
class Delta : public ParticleSystemSPH {
 public:
  Delta(const Parameters& base, const ParametersSPH& sph);

  std::string KernelName() const override;
  double Support() const override { return SupportOf(parameters_sph.delta.kernel) * parameters_sph.smoothing_length; }
  std::vector<PassPlan> Plan() const override;
  std::vector<StepLimit> StepLimits() const override;
  std::size_t Bytes() const override;
  void Transfer(Archive& archive) override;

  /// The renormalised gradient of density of the last step [kg/m^4], of a liquid; 0 where there are too few others.
  std::vector<Vec2> DensityGradient() const;

 protected:
  void ComputeAccelerations() override;
  void InitialPositions() override;
  void Reorder(std::span<const std::uint32_t> order) override;
  void AfterStep() override;
  std::optional<Breach> FindBreach() const override;
  std::optional<Breach> FindBrokenStart() const override;
  double StableSoundStep() const override;
  double ListsHoldBefore() const override { return IsGas() ? 0 : LastStep(); }
  void ResizeArrays(std::size_t n) override;
  void ComputeDensities(ListBlock& block) override;
  void AddSpatialInteraction(const ListBlock& block) override;

 private:
  /// Of a liquid, in the order of the particles, images after them.
  template <typename Real>
  struct Arrays {
    std::vector<Real> volume, excess, pressure, vx, vy, gradient_x, gradient_y, wholeness, next_wholeness;
    std::vector<Real> rate, strain, concentration;
    std::vector<Real> shift_x, shift_y;  // sums of the force pass; once the step is made, the shifts [m]

    std::array<std::vector<Real>*, 14> All() {
      return {&volume,    &excess,         &pressure, &vx,     &vy,      &gradient_x,    &gradient_y,
              &wholeness, &next_wholeness, &rate,     &strain, &shift_x, &concentration, &shift_y};
    }
    /// What a step leaves to the next, in the order of the particles.
    std::array<std::vector<Real>*, 6> Kept() {
      return {&gradient_x, &gradient_y, &wholeness, &strain, &shift_x, &shift_y};
    }
  };

  bool IsGas() const { return std::holds_alternative<Polytrope>(parameters_sph.equation_of_state); }
  double Rho0() const { return ReferenceDensity(parameters_sph.equation_of_state); }
  /// Speed of sound at the reference density [m/s].
  double Sound() const;
  bool HasTension() const { return !IsGas() && parameters_sph.delta.surface_tension > 0; }
  void AdvanceDensity();
  void Shift();
  void TieDensity();
  bool InOrder(double density) const;
  /// Of the images, from those of their sources: velocities, turned round in mirrors relative to the wall; the gradient
  /// of density, turned round, too; and what follows from the weight of the fluid between an image and its source.
  template <typename Real>
  void CopyVelocitiesToImages(Arrays<Real>& arrays, const SideVelocities& sides) const;
  template <typename Real>
  void CopyGradientToImages(Arrays<Real>& arrays) const;
  template <typename Real>
  void CopyPressureToImages(Arrays<Real>& arrays) const;
  /// A vector that a mirror turns round.
  template <typename Real>
  void CopyVectorToImages(std::vector<Real>& x, std::vector<Real>& y) const;
  /// Of the wall particles, from those of the fluid and its images: see ComputeWallValues. Velocities are turned round
  /// relative to the wall, those along it only where the fluid sticks to it.
  template <typename Real>
  void SetWallParticles(const FluidArrays<Real>& fluid, Arrays<Real>& arrays, const SideVelocities& sides);
  void ComputeForces();
  void ComputeWaterForces();
  void AddTension();
  void AddWallFriction(std::size_t first, std::size_t last);
  template <typename Real>
  WaterInput<Real> WaterOf(const Arrays<Real>& arrays) const;

  LatticeSums lattice_;           // of the kernel
  std::vector<double> density_;   // [kg/m^3], of a liquid
  bool density_in_order_ = true;  // else density_ is still that of the step before
  double density_span_ = 0;       // [s], by which it was advanced last
  long density_step_ = -1;        // the step that density_ is of; -1 at the start, before any forces
  std::vector<double> mid_x_, mid_y_;
  std::variant<Arrays<float>, Arrays<double>> arrays_;
  std::variant<SurfaceArrays<float>, SurfaceArrays<double>> surface_;  // empty without tension
  std::variant<WallValues<float>, WallValues<double>> wall_values_;    // empty without wall particles
};

}  // namespace sph
