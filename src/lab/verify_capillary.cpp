// A drop with surface tension: how it swings, and the pressure inside.
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"

namespace sph {

std::vector<Verdict> MeasureCapillaryDrop(ParticleSystemSPH& system) {
  constexpr double kPi = std::numbers::pi;
  constexpr int kCrossings = 6;  // of the circular shape: three periods
  const double tension = system.parameters_sph.delta.surface_tension;
  const double rho0 = ReferenceDensity(system.parameters_sph.equation_of_state);
  const Particles& p = system.State();
  double mass = 0;
  for (std::size_t i = 0; i < p.Size(); ++i) mass += p.mass[i];
  const double radius = std::sqrt(mass / (kPi * rho0));  // the lattice's share of the disk
  const double period = 2 * kPi * std::sqrt(rho0 * radius * radius * radius / (6 * tension));
  std::vector<double> crossings;
  double before = 0, pressure = 0;
  long samples = 0;
  while (crossings.size() < kCrossings && system.Time() < 4 * period && !system.Trouble()) {
    const double then = system.Time();
    system.Step();
    const Vec2 moments = SecondMoments(p);
    const double now = moments.x - moments.y;
    if (before * now < 0) crossings.push_back(then + (system.Time() - then) * before / (before - now));
    before = now;
    if (crossings.size() < 2) continue;
    const std::vector<double> pressures = system.Pressure();
    for (std::size_t i = 0; i < p.Size(); ++i) {
      if (Length(p.Position(i)) > 0.5 * radius) continue;
      pressure += pressures[i];
      ++samples;
    }
  }
  const bool whole = crossings.size() == kCrossings;
  // Over whole periods, so that a rest shape that is not quite round does not count.
  const double measured = whole ? 0.5 * (crossings[5] - crossings[1]) : 0;
  const Promise first{1, "tension acts over the width of a kernel"};
  return {{.metric = "period of two crests, relative error",
           .value = whole ? measured / period - 1 : kBroken,
           .bar = 0.05,
           .reference = "2 pi sqrt(rho R^3/(6 sigma)) [Rayleigh 1879; Lamb, art. 273]",
           .promise = first},
          {.metric = "mean pressure inside, relative error",
           .value = whole ? pressure / static_cast<double>(samples) * radius / tension - 1 : kBroken,
           .bar = 0.05,
           .reference = "sigma/R [Laplace]",
           .promise = first}};
}

}  // namespace sph
