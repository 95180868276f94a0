// The passes once more, in the plainest way: sums over all pairs, written from the equations and not from the fast
// code.
#pragma once

#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "sph/clouds.hpp"

namespace sph {

/// A sum, and what its rounding is measured by: the number of terms, and the sum of the greatest sizes that the terms
/// can have with these masses and pressures, wherever in the support the neighbours are.
struct PlainSum {
  Vec2 value;
  double size = 0;
  std::size_t terms = 0;

  /// Bound for the difference between two ways to sum in double precision: each term is within 16 roundings of its
  /// greatest size (differences such as 2 - q lose what they lose in absolute, not in relative terms), and each
  /// addition adds one rounding of the sum.
  double RoundOff() const;
};

/// rho_i = sum_j m_j W(|x_i - x_j|, h), eq. 5 and 8 of Braune & Lewiner; value.x is the density.
std::vector<PlainSum> PlainDensity(const Cloud& cloud, double h);

/// The same with Poly6 in the plane.
std::vector<PlainSum> PlainPoly6Density(const Cloud& cloud, double h);

/// dv_i/dt of eq. 10 of Braune & Lewiner with the kernel of eq. 5.
std::vector<PlainSum> PlainPressureAcceleration(const Cloud& cloud, std::span<const double> density,
                                                std::span<const double> pressure, double h);

/// Pressure and viscosity of Mueller, Charypar & Gross 2003, eqs. 10 and 14, over rho_i, with the plane's kernels; or,
/// if `published`, what the tutorial's program computes in their place.
std::vector<PlainSum> PlainMuellerForces(const Cloud& cloud, std::span<const double> density,
                                         std::span<const double> pressure, double h, double mu, bool published);

}  // namespace sph
