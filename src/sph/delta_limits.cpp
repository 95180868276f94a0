// How long a step the accurate solver allows, by its kernel and its terms.
#include <algorithm>

#include "sph/delta.hpp"

namespace sph {
std::string Delta::KernelName() const { return PropertiesOf(parameters_sph.delta.kernel).name; }

namespace {

/// As KernelProperties::spread, of the weights of the viscous force.
constexpr double kSepticSpread = 0.081;

/// The same of the density's diffusion with that delta (of half a support radius), where leapfrog takes sound at once.
/// Waves that swing fastest are damped less than others, as the gradients take most of it away; those that diffusion
/// damps most are slow, and keep the step that they would keep alone: spread/delta.
double DiffusiveStep(double delta, double sound_step, bool sharp, const KernelProperties& kernel) {
  const double alone = kernel.spread / (delta * sound_step);
  const double swinging = sharp ? std::max(kernel.damped_sound, kernel.sharp_damped * delta) : kernel.damped_sound;
  return 1 / std::max(swinging, (1 - alone * alone) / kernel.spread);
}

}  // namespace

/// A little below the lattice's, as particles are not on one (`sphlab stress step-limit`); gas with few neighbours more
/// so.
double Delta::StableSoundStep() const {
  const KernelProperties& kernel = PropertiesOf(parameters_sph.delta.kernel);
  const bool few = Support() < 3.2 * InitialSpacing();
  if (IsGas()) return (few ? 0.74 : 0.97) * kernel.gas_step;
  return 0.94 * (parameters_sph.delta.sharp_gradient ? kernel.sharp_step : kernel.water_step);
}

std::vector<StepLimit> Delta::StepLimits() const {
  std::vector<StepLimit> limits = ParticleSystemSPH::StepLimits();
  if (IsGas()) return limits;
  const DeltaParameters& delta = parameters_sph.delta;
  const KernelProperties& kernel = PropertiesOf(delta.kernel);
  const double half2 = 0.25 * Support() * Support();
  const double h_c = parameters_sph.smoothing_length * Sound();
  const double spreading = delta.diffusion * h_c;
  if (spreading > 0) {
    const double step =
        DiffusiveStep(spreading / (0.5 * Support() * Sound()), StableSoundStep(), delta.sharp_gradient, kernel);
    limits.push_back({"density diffusion", step * half2 / spreading, LimitKind::kDecaying});
  }
  // Leapfrog with the rate of half a step before is stable for (w dt)^2 + 2 alpha h c k^2 dt < 4, w = c k.
  const double damping = delta.sound_damping * h_c;
  if (damping > 0) {
    limits.push_back(
        {"sound damping", 0.5 * StableSoundStep() * StableSoundStep() * half2 / damping, LimitKind::kDecaying});
  }
  // Half of these, because the velocity at the step is extrapolated from two half steps (Adams-Bashforth). In the form
  // of stresses the greatest eigenvalue is at most the trace, which is four times the plain sum.
  const double artificial = delta.artificial_viscosity * h_c;
  if (artificial > 0)
    limits.push_back({"artificial viscosity", 0.5 * kernel.along_spread * half2 / artificial, LimitKind::kDecaying});
  const double nu = parameters_sph.viscosity / Rho0();
  const double viscous = delta.viscous_form == ViscousForm::kStress ? 0.25 * kernel.spread : kSepticSpread;
  if (nu > 0) limits.push_back({"viscosity", 0.5 * viscous * half2 / nu, LimitKind::kDecaying});
  if (HasTension()) {
    limits.push_back({"surface tension", LongestTensionStep(Support(), Rho0(), delta.surface_tension)});
  }
  return limits;
}

}  // namespace sph
