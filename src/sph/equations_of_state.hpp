// Equations of state: pressure (in the precision of the density), speed of sound and specific internal energy.
#pragma once

#include <cmath>
#include <variant>

namespace sph {

/// P = k rho^2, the toy star's gas [Braune & Lewiner eq. 20].
struct Polytrope {
  double k = 0;  ///< [Pa m^4/kg^2]

  template <typename Real>
  Real Pressure(Real rho) const {
    return static_cast<Real>(k) * rho * rho;
  }
  /// rho [kg/m^3] at a pressure [Pa] >= 0.
  double Density(double pressure) const { return std::sqrt(pressure / k); }
  /// c [m/s], c^2 = dP/drho.
  double SoundSpeed(double rho) const { return std::sqrt(2 * k * rho); }
  /// u [J/kg], du/drho = P/rho^2.
  double InternalEnergy(double rho) const { return k * rho; }
};

/// P = k ((rho/rho0)^gamma - 1) [Braune & Lewiner eq. 23, with gamma = 7]. Negative pressure below rho0 is not clipped.
struct Tait {
  double k = 0;         ///< [Pa]
  double rho0 = 0;      ///< [kg/m^3]
  double exponent = 7;  ///< gamma > 1

  template <typename Real>
  Real Pressure(Real rho) const {
    return static_cast<Real>(k) * (Power(rho / static_cast<Real>(rho0)) - 1);
  }
  double Density(double pressure) const { return rho0 * std::pow(1 + pressure / k, 1 / exponent); }
  double SoundSpeed(double rho) const { return std::sqrt(exponent * k / rho * Power(rho / rho0)); }
  /// u is 0 at rho0.
  double InternalEnergy(double rho) const {
    return k / rho * (Power(rho / rho0) / (exponent - 1) + 1) - k / rho0 * exponent / (exponent - 1);
  }

 private:
  template <typename Real>
  Real Power(Real s) const {
    if (exponent != 7) return std::pow(s, static_cast<Real>(exponent));
    const Real s2 = s * s;
    return s2 * s2 * s2 * s;
  }
};

/// P = k (rho - rho0) [Mueller, Charypar & Gross 2003, eq. 12].
struct IdealGas {
  double k = 0;     ///< [m^2/s^2]
  double rho0 = 0;  ///< [kg/m^3]

  template <typename Real>
  Real Pressure(Real rho) const {
    return static_cast<Real>(k) * (rho - static_cast<Real>(rho0));
  }
  double Density(double pressure) const { return rho0 + pressure / k; }
  double SoundSpeed(double) const { return std::sqrt(k); }
  /// u is 0 at rho0.
  double InternalEnergy(double rho) const { return k * (std::log(rho / rho0) + rho0 / rho - 1); }
};

using EquationOfState = std::variant<Polytrope, Tait, IdealGas>;

/// rho0 [kg/m^3] of a liquid; 0 for a gas.
inline double ReferenceDensity(const EquationOfState& equation) {
  if (const auto* tait = std::get_if<Tait>(&equation)) return tait->rho0;
  if (const auto* gas = std::get_if<IdealGas>(&equation)) return gas->rho0;
  return 0;
}

}  // namespace sph
