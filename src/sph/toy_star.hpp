// The static toy star's exact density, and how far a run is from it.
#pragma once

#include <span>

#include "base/vec2.hpp"

namespace sph {

/// Gas of P = k rho^2 held together by a = -lambda x [Braune & Lewiner, VI].
struct ToyStar {
  double mass = 0;    ///< M [kg/m]
  double radius = 0;  ///< R, r_e in eq. 22 [m]
  double k = 0;       ///< pressure constant [Pa m^4/kg^2]

  /// lambda [1/s^2] = 8 k M/(pi R^4), for which the star of mass M ends at R (Table I; from the integral of eq. 22).
  double CentralForce() const;
  /// rho(r) [kg/m^3] = lambda/(4k) (R^2 - r^2) [eq. 22, where nu is printed for lambda], 0 from R on.
  double Density(double r) const;
};

struct DensityErrors {
  double mse = 0;           ///< mean of (rho - exact)^2 [kg^2/m^6]
  double rms_relative = 0;  ///< its root over the exact density in the centre
};

/// Over all particles at (x[i], y[i]) with density[i].
DensityErrors CompareDensity(const ToyStar& star, std::span<const double> x, std::span<const double> y,
                             std::span<const double> density);

}  // namespace sph
