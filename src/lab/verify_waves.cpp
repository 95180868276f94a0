// The standing wave against the exact dispersion relation of a viscous fluid.
#include <cmath>
#include <numbers>

#include "lab/standing_wave.hpp"
#include "lab/verification.hpp"

namespace sph {

/// The deflection is the part of the velocity that has the wave's shape: sum m u.phi/sum m phi.phi.
std::vector<Verdict> MeasureStandingWave(ParticleSystemSPH& system) {
  constexpr int kPeriods = 8;
  constexpr int kSamples = 100;  // a period
  const Box box = system.parameters.fluid.region.box;
  const StandingWave wave{2 * std::numbers::pi / box.Width(), box.Height(),
                          system.parameters_sph.viscosity / ReferenceDensity(system.parameters_sph.equation_of_state),
                          -system.parameters.gravity.y};
  const std::complex<double> exact = wave.Root();
  const double period = 2 * std::numbers::pi / exact.imag();
  const auto deflection = [&] {
    const Particles& p = system.State();
    double along = 0, norm = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const Vec2 shape = wave.Shape(p.x[i] - box.x0, p.y[i] - box.y0);
      along += p.mass[i] * Dot(p.Velocity(i), shape);
      norm += p.mass[i] * Dot(shape, shape);
    }
    return along / norm;
  };
  PointSeries samples;
  for (int k = 0; k <= kPeriods * kSamples && !system.Trouble(); ++k) {
    AdvanceTo(system, period * k / kSamples);
    samples.push_back({system.Time(), deflection()});
  }
  const std::complex<double> measured = FitDecay(samples);
  const bool broken = system.Trouble().has_value();
  const auto error = [&](double value, double of) { return broken ? kBroken : value / of - 1; };
  return {{.metric = "decay rate over eight periods, relative error",
           .value = error(measured.real(), exact.real()),
           .bar = 0.02,
           .reference = "exact linear dispersion"},
          {.metric = "frequency, relative error",
           .value = error(measured.imag(), exact.imag()),
           .bar = 0.004,
           .reference = "exact linear dispersion"}};
}

}  // namespace sph
