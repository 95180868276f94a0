// How long a step the accurate solver allows, by its kernel and its terms.
#include "sph/delta.hpp"

namespace sph {
namespace {

/// What is known of a kernel's fluid on lattices. Lengths are in half support radii, as which h counts here: it is h
/// but for the quintic spline.
struct KernelProperties {
  const char* name;
  double water_step;  ///< greatest stable c dt: 2/max(K W(K)) of the kernel's Fourier transform
  double gas_step;    ///< the same for P = rho c^2/2
  /// 1/max(sum V (-W'/r)(1 - cos k.x)) over the waves on a square lattice, the least for spacings from 1/1.6 to 1/2.8:
  /// of the plain weights, with which density spreads, and of the sharp ones of the viscous force.
  double plain_spread, sharp_spread;
  /// 2/max of the greater eigenvalue of sum V (-W'/r) (r r^T/r^2)(1 - cos k.x): of the artificial viscosity, along
  /// pairs.
  double along_spread;
};

const KernelProperties& Properties(SmoothingKernel kernel) {
  static constexpr KernelProperties kProperties[] = {{"Wendland C2", 1.76, 1.25, 0.29, 0.126, 0.9},
                                                     {"Wendland C4", 1.53, 1.09, 0.22, 0.102, 0.66},
                                                     {"quintic spline", 1.54, 1.09, 0.23, 0.106, 0.66}};
  return kProperties[static_cast<std::size_t>(kernel)];
}

}  // namespace

std::string Delta::KernelName() const { return Properties(parameters_sph.delta.kernel).name; }

/// A little below the lattice's, as particles are not on one (`sphlab stress step-limit`); gas with few neighbours more
/// so.
double Delta::StableSoundStep() const {
  const KernelProperties& kernel = Properties(parameters_sph.delta.kernel);
  const bool few = Support() < 3.2 * InitialSpacing();
  return IsGas() ? (few ? 0.74 : 0.97) * kernel.gas_step : 0.985 * kernel.water_step;
}

std::vector<StepLimit> Delta::StepLimits() const {
  std::vector<StepLimit> limits = ParticleSystemSPH::StepLimits();
  if (IsGas()) return limits;
  const DeltaParameters& delta = parameters_sph.delta;
  const KernelProperties& kernel = Properties(delta.kernel);
  const double half2 = 0.25 * Support() * Support();
  const double h_c = parameters_sph.smoothing_length * Sound();
  const double spreading = delta.diffusion * h_c;
  if (spreading > 0) limits.push_back({"density diffusion", kernel.plain_spread * half2 / spreading, true});
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
  const double viscous = delta.viscous_form == ViscousForm::kStress ? 0.25 * kernel.plain_spread : kernel.sharp_spread;
  if (nu > 0) limits.push_back({"viscosity", 0.5 * viscous * half2 / nu, true});
  if (HasTension()) {
    limits.push_back({"surface tension", LongestTensionStep(Support(), Rho0(), delta.surface_tension)});
  }
  return limits;
}

}  // namespace sph
