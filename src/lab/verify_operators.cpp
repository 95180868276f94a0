// Sums over particles against what they stand for: how their errors fall with the spacing, on a lattice and in
// disorder.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/lattice_waves.hpp"
#include "lab/verification.hpp"
#include "scenes/build.hpp"
#include "sph/delta.hpp"

namespace sph {
namespace {

/// Root mean square of errors over that of what is exact.
class RelativeRms {
 public:
  void Add(Vec2 computed, Vec2 exact) {
    const Vec2 error = computed - exact;
    errors_ += Dot(error, error);
    exact_ += Dot(exact, exact);
  }
  double Value() const { return std::sqrt(errors_ / exact_); }

 private:
  double errors_ = 0, exact_ = 0;
};

/// Of the flow at the start [Pa/m], by differences of fourth order over a thousandth of its period.
Vec2 PressureGradient(const ParticleSystemSPH& flow, Vec2 at) {
  const double d = 1e-3 * flow.parameters_sph.periods.box.Width();
  const auto along = [&](Vec2 step) {
    const auto difference = [&](double times) {
      return flow.FlowAt(at + times * step).pressure - flow.FlowAt(at - times * step).pressure;
    };
    return (8 * difference(1) - difference(2)) / (12 * d);
  };
  return {along({d, 0}), along({0, d})};
}

/// Of the density, by the renormalised gradient.
double GradientError(const ParticleSystemSPH& frozen) {
  const std::vector<Vec2> computed = dynamic_cast<const Delta&>(frozen).DensityGradient();
  const EquationOfState& equation = frozen.parameters_sph.equation_of_state;
  const double c = std::visit([&](const auto& of) { return of.SoundSpeed(ReferenceDensity(equation)); }, equation);
  RelativeRms error;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    error.Add(computed[i], 1 / (c * c) * PressureGradient(frozen, frozen.State().Position(i)));
  }
  return error.Value();
}

double PressureForceError(const ParticleSystemSPH& frozen) {
  const double rho0 = ReferenceDensity(frozen.parameters_sph.equation_of_state);
  const Particles& p = frozen.State();
  RelativeRms error;
  for (std::size_t i = 0; i < p.Size(); ++i) {
    error.Add({p.ax[i], p.ay[i]}, -1 / rho0 * PressureGradient(frozen, p.Position(i)));
  }
  return error.Value();
}

/// Of what viscosity adds; lap u = -8 pi^2/L^2 u.
double ViscousForceError(const ParticleSystemSPH& viscous, const ParticleSystemSPH& ideal) {
  const ParametersSPH& sph = viscous.parameters_sph;
  const double side = sph.periods.box.Width();
  const double decay =
      8 * std::numbers::pi * std::numbers::pi / (side * side) * sph.viscosity / ReferenceDensity(sph.equation_of_state);
  const Particles& with = viscous.State();
  const Particles& without = ideal.State();
  RelativeRms error;
  for (std::size_t i = 0; i < with.Size(); ++i) {
    error.Add({with.ax[i] - without.ax[i], with.ay[i] - without.ay[i]},
              -decay * viscous.FlowAt(with.Position(i)).velocity);
  }
  return error.Value();
}

/// Of a wave of the length 1/h_per_wave smoothing lengths, at the points of a lattice so fine that it leaves no
/// error of its own.
double InterpolationError(const RadialKernel& kernel, double h_per_wave) {
  constexpr int kPerH = 6;  // spacings
  const int reach = static_cast<int>(kernel.support * kPerH);
  double sum = 0;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const double x = static_cast<double>(column) / kPerH;
      const double q = std::hypot(x, static_cast<double>(row) / kPerH);
      if (q < kernel.support) sum += kernel.value(q) * std::cos(2 * std::numbers::pi * h_per_wave * x);
    }
  }
  return std::abs(1 - sum / (kPerH * kPerH));
}

/// Of the error with half of these smoothing lengths over that with these, the greatest of the solvers' kernels.
double ReductionByHalving(double h_per_wave) {
  double worst = 0;
  for (const RadialKernel& kernel :
       {CubicSplineOfUnitLength(), WendlandC2OfUnitLength(), WendlandC4OfUnitLength(), QuinticSplineOfUnitLength()}) {
    worst = std::max(worst, InterpolationError(kernel, 0.5 * h_per_wave) / InterpolationError(kernel, h_per_wave));
  }
  return worst;
}

}  // namespace

void Freeze(Scene& scene) {
  scene.base.adaptive_step = false;
  scene.base.time_step = 1e-9;
  scene.sph.delta.sound_damping = 0;
  scene.sph.delta.shifting = false;
}

/// The vortices at 25 x 25, 50 x 50 and 100 x 100 particles, on a lattice and moved by up to a tenth of the spacing,
/// and as given, after a step in which nothing moves.
std::vector<Verdict> MeasureOperators(ParticleSystemSPH& system) {
  const auto gradient_error = [&](const std::string& arrange, std::size_t particles) {
    SceneRequest request;
    request.scene = "taylor-green";
    request.settings = {"fluid.arrange=" + arrange, "forces.viscosity=0"};
    request.particles = particles;
    request.threads = system.parameters.threads;
    Scene scene = LoadScene(request);
    Freeze(scene);
    const auto frozen = MakeSystem(scene);
    frozen->Step();
    return GradientError(*frozen);
  };
  system.Step();
  ParametersSPH with_viscosity = system.parameters_sph;
  with_viscosity.viscosity = 0.01;
  Delta viscous(system.parameters, with_viscosity);
  viscous.Reset();
  viscous.Step();
  const double lattice = gradient_error("lattice", 2500);
  const double disorder = gradient_error("perturbed", 2500);
  const auto fourfold = [](const char* metric, double value, double bar) {
    return Verdict{
        .metric = metric, .value = value, .bar = bar, .reference = "second order: 1/4", .kind = MetricKind::kRatio};
  };
  const auto force = [](const char* metric, double value) {
    return Verdict{.metric = metric,
                   .value = value,
                   .bar = 0.01,
                   .reference = "exact; what so long an h leaves at any spacing",
                   .kind = MetricKind::kBounded};
  };
  return {
      fourfold("wave summed with any kernel, h halved, fine lattice", ReductionByHalving(0.05), 0.26),
      fourfold("gradient of density, lattice, 50 x 50 over 25 x 25", lattice / gradient_error("lattice", 625), 0.28),
      fourfold("gradient of density, lattice, 100 x 100 over 50 x 50", gradient_error("lattice", 10'000) / lattice,
               0.28),
      fourfold("gradient of density, disorder, 50 x 50 over 25 x 25", disorder / gradient_error("perturbed", 625),
               0.28),
      fourfold("gradient of density, disorder, 100 x 100 over 50 x 50", gradient_error("perturbed", 10'000) / disorder,
               0.28),
      force("pressure force, lattice, relative error", PressureForceError(system)),
      force("viscous force, lattice, relative error", ViscousForceError(viscous, system)),
  };
}

}  // namespace sph
