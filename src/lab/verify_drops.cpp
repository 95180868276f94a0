// Drops without walls: the one that becomes an ellipse, and the square that turns.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/verification.hpp"
#include "particles/diagnostics.hpp"

namespace sph {
namespace {

constexpr double kBroken = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<Verdict> MeasureEllipticDrop(ParticleSystemSPH& system) {
  // A' = A^2 (a^4 - 1)/(a^4 + 1), a' = -a A, b = 1/a from A = 100/s: b at t = 0.0076 s [J. J. Monaghan, J. Comput.
  // Phys. 110 (1994) 399].
  constexpr double kEnd = 0.0076;
  constexpr double kLongAxis = 1.944517;
  const double moment = SecondMoments(system.State()).y;
  const double energy = Diagnose(system).kinetic_energy;
  AdvanceTo(system, kEnd);
  const bool broken = system.Trouble().has_value();
  const double axis = std::sqrt(SecondMoments(system.State()).y / moment);
  const double kept = Diagnose(system).kinetic_energy / energy;
  return {
      {"long axis at t = 0.0076 s, relative error", broken ? kBroken : std::abs(axis / kLongAxis - 1), 0.002,
       "ordinary differential equations; elsewhere 0.0103"},
      {"kinetic energy, relative error", broken ? kBroken : std::abs(kept - 1), 0.005, "constant; elsewhere 0.031"}};
}

std::vector<Verdict> MeasureRotatingSquare(ParticleSystemSPH& system) {
  const double momentum = Diagnose(system).angular_momentum;
  AdvanceTo(system, 3);
  const double kept = Diagnose(system).angular_momentum / momentum;
  // Particles that have another within half a spacing.
  const Particles& p = system.State();
  const double near = 0.5 * system.InitialSpacing();
  std::vector<std::uint32_t> by_x(p.Size());
  for (std::uint32_t i = 0; i < p.Size(); ++i) by_x[i] = i;
  std::sort(by_x.begin(), by_x.end(), [&](std::uint32_t a, std::uint32_t b) { return p.x[a] < p.x[b]; });
  std::vector<bool> paired(p.Size());
  for (std::size_t k = 0; k < by_x.size(); ++k) {
    for (std::size_t m = k + 1; m < by_x.size() && p.x[by_x[m]] - p.x[by_x[k]] < near; ++m) {
      if (Length(p.Position(by_x[k]) - p.Position(by_x[m])) < near) paired[by_x[k]] = paired[by_x[m]] = true;
    }
  }
  const double share = static_cast<double>(std::ranges::count(paired, true)) / static_cast<double>(p.Size());
  const bool broken = system.Trouble().has_value();
  return {{"angular momentum at w t = 3, relative error", broken ? kBroken : std::abs(kept - 1), 0.002, "constant"},
          {"share of paired particles", broken ? kBroken : share, 0.05,
           "none; delta-SPH with shifting 0.044, without 0.213"}};
}

}  // namespace sph
