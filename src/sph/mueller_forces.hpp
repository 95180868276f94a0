// Pressure and viscosity between neighbours after Mueller, Charypar & Gross 2003, eqs. 10 and 14, with the plane's
// kernels.
#pragma once

#include <numbers>
#include <span>

#include "sph/kernels.hpp"
#include "sph/neighbour_store.hpp"

namespace sph {

/// W'(r) of the Spiky kernel in the plane.
struct SpikySlope {
  explicit SpikySlope(double h) : kernel(h) {}
  double operator()(double r) const { return kernel.Slope(r); }
  Spiky kernel;
};

/// What the tutorial's program has in its place: -10/(pi h^5) (h - r)^3, with the sign of the direction turned round.
/// Its pressures are all negative, because its densities stay far below rho0; the two reversals cancel, and particles
/// repel.
struct PublishedSpikySlope {
  explicit PublishedSpikySlope(double radius) : h(radius), c(10 / (std::numbers::pi * h * h * h * h * h)) {}
  double operator()(double r) const { return c * (h - r) * (h - r) * (h - r); }
  double h;
  double c;
};

/// The arrays of all particles that the forces read and write.
struct MuellerArrays {
  std::span<const double> x, y, vx, vy;             ///< [m], [m/s]
  std::span<const double> mass, density, pressure;  ///< [kg/m], [kg/m^3], [Pa]
  std::span<double> ax, ay;                         ///< [m/s^2]
};

/// Adds to the block's particles
///   a_i = 1/rho_i sum_j m_j/rho_j ( -(P_i + P_j)/2 W'(r) (x_i - x_j)/r + mu (v_j - v_i) lap W(r) ).
/// Coincident particles exert no pressure on each other: their direction is undefined.
/// @param mu  dynamic viscosity [Pa s]; the term is not computed when it is 0.
template <typename Slope>
void AddMuellerForces(const NeighbourBlock& block, const Slope& slope, const ViscosityKernel& viscosity_kernel,
                      double mu, const MuellerArrays& p) {
  for (std::size_t k = 0; k < block.Size(); ++k) {
    const std::size_t i = block.First() + k;
    const auto neighbours = block.Numbers(k);
    const auto distances = block.Distances(k);
    double fx = 0;
    double fy = 0;
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
      const std::size_t j = neighbours[n];
      const double r = distances[n];
      const double volume = p.mass[j] / p.density[j];
      const double push = r > 0 ? -volume * 0.5 * (p.pressure[i] + p.pressure[j]) * slope(r) / r : 0;
      fx += push * (p.x[i] - p.x[j]);
      fy += push * (p.y[i] - p.y[j]);
      if (mu != 0) {
        const double drag = mu * volume * viscosity_kernel.Laplacian(r);
        fx += drag * (p.vx[j] - p.vx[i]);
        fy += drag * (p.vy[j] - p.vy[i]);
      }
    }
    p.ax[i] += fx / p.density[i];
    p.ay[i] += fy / p.density[i];
  }
}

}  // namespace sph
