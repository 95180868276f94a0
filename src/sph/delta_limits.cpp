// How long a step the accurate solver allows, by its kernel and its terms.
#include <algorithm>

#include "sph/delta.hpp"

namespace sph {
std::string Delta::KernelName() const { return PropertiesOf(parameters_sph.delta.kernel).name; }

namespace {

/// As KernelProperties::spread, of the weights of the viscous force.
constexpr double kSepticSpread = 0.081;

/// The same of the density's diffusion with that delta, where leapfrog takes sound at once. Waves that diffusion damps
/// most, at the rate d delta, are slow, and those that swing fastest are damped by d' delta, as the gradients take most
/// of it away: on lattices 1.07 delta keeps the joint limit of both up to delta = 0.2, and beyond the first alone do.
double DiffusiveStep(double delta, double spread) {
  constexpr double kOfSound = 1.07, kUpTo = 0.2;
  const double alone = 1 / spread;
  return 1 / std::max(kOfSound, alone - (alone - kOfSound) * kUpTo / std::max(delta, kUpTo));
}

}  // namespace

/// A little below the lattice's, as particles are not on one (`sphlab stress step-limit`); gas with few neighbours more
/// so.
double Delta::StableSoundStep() const {
  const KernelProperties& kernel = PropertiesOf(parameters_sph.delta.kernel);
  const bool few = Support() < 3.2 * InitialSpacing();
  return IsGas() ? (few ? 0.74 : 0.97) * kernel.gas_step : 0.985 * kernel.water_step;
}

std::vector<StepLimit> Delta::StepLimits() const {
  std::vector<StepLimit> limits = ParticleSystemSPH::StepLimits();
  if (IsGas()) return limits;
  const DeltaParameters& delta = parameters_sph.delta;
  const KernelProperties& kernel = PropertiesOf(delta.kernel);
  const double half2 = 0.25 * Support() * Support();
  const double h_c = parameters_sph.smoothing_length * Sound();
  const double spreading = delta.diffusion * h_c;
  if (spreading > 0)
    limits.push_back({"density diffusion", DiffusiveStep(delta.diffusion, kernel.spread) * half2 / spreading, true});
  // Leapfrog with the rate of half a step before is stable for (w dt)^2 + 2 alpha h c k^2 dt < 4, w = c k.
  const double damping = delta.sound_damping * h_c;
  if (damping > 0) {
    limits.push_back({"sound damping", 0.5 * StableSoundStep() * StableSoundStep() * half2 / damping, true});
  }
  // Half of these, because the velocity at the step is extrapolated from two half steps (Adams-Bashforth). In the form
  // of stresses the greatest eigenvalue is at most the trace, which is four times the plain sum.
  const double artificial = delta.artificial_viscosity * h_c;
  if (artificial > 0) limits.push_back({"artificial viscosity", 0.5 * kernel.along_spread * half2 / artificial, true});
  const double nu = parameters_sph.viscosity / Rho0();
  const double viscous = delta.viscous_form == ViscousForm::kStress ? 0.25 * kernel.spread : kSepticSpread;
  if (nu > 0) limits.push_back({"viscosity", 0.5 * viscous * half2 / nu, true});
  if (HasTension()) {
    limits.push_back({"surface tension", LongestTensionStep(Support(), Rho0(), delta.surface_tension)});
  }
  return limits;
}

}  // namespace sph
