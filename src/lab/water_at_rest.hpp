// Water at rest in a tank: where its surface is, and its pressure.
#pragma once

#include <cmath>

#include "sph/particle_system_sph.hpp"

namespace sph {

/// The water of a tank at rest: p = c^2 rho0 (exp(g.(x - x_s)/c^2) - 1), as p = c^2 (rho - rho0) and grad p = rho g.
/// Its surface is normal to g.
struct WaterAtRest {
  Box tank;
  double rho0 = 0;    ///< [kg/m^3]
  double sound2 = 0;  ///< c^2 [m^2/s^2]
  double mass = 0;    ///< [kg/m]
  Vec2 gravity;       ///< [m/s^2]

  /// The mean height H of the surface, which is its height in the middle of the tank, of width w: with rho = rho0 (1 +
  /// g.(x - x_s)/c^2) the mass is rho0 w (H + |g_y|/(2 c^2) (H^2 + s^2 w^2/12)), s = g_x/g_y being the surface's slope.
  double Height() const {
    const double filled = mass / (rho0 * tank.Width());
    const double slope = gravity.x / gravity.y;
    const double squares = filled * filled + slope * slope * tank.Width() * tank.Width() / 12;
    return filled + gravity.y / (2 * sound2) * squares;
  }
  double Pressure(Vec2 at) const {
    const Vec2 surface{tank.Centre().x, tank.y0 + Height()};
    return sound2 * rho0 * std::expm1(Dot(gravity, at - surface) / sound2);
  }
};

/// Of the fluid that these particles are, in the tank that the walls make.
inline WaterAtRest RestOf(const ParticleSystemSPH& system, const Particles& particles) {
  const EquationOfState& equation = system.parameters_sph.equation_of_state;
  const double rho0 = ReferenceDensity(equation);
  const double sound = std::visit([&](const auto& of) { return of.SoundSpeed(rho0); }, equation);
  double mass = 0;
  for (const double of_one : particles.mass) mass += of_one;
  return {LegalRegion(system.parameters.walls), rho0, sound * sound, mass, system.parameters.gravity};
}

}  // namespace sph
