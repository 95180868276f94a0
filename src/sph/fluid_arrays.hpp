// What the passes over neighbours read and write, in their precision; all arrays in the order of the particles.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "neighbours/positions.hpp"

namespace sph {

template <typename Real>
struct FluidArrays {
  Positions<Real> positions;
  std::vector<Real> mass;           ///< [kg/m]; empty if all are equal
  std::vector<Real> density;        ///< [kg/m^3]
  std::vector<Real> pressure_term;  ///< P/rho^2 [m^5/(kg s^2)]

  const Real* Masses() const { return mass.empty() ? nullptr : mass.data(); }
  std::size_t Bytes() const {
    return positions.Bytes() + sizeof(Real) * (mass.capacity() + density.capacity() + pressure_term.capacity());
  }
};

using AnyFluidArrays = std::variant<FluidArrays<float>, FluidArrays<double>>;

/// `to` becomes `from` and padding, in the precision of the passes.
template <typename Real>
void Convert(std::span<const double> from, std::vector<Real>& to) {
  to.resize(from.size() + kPadding);
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<Real>(from[i]);
}

}  // namespace sph
