#include "sph/toy_star.hpp"

#include <cmath>
#include <numbers>

namespace sph {

double ToyStar::CentralForce() const { return 8 * k * mass / (std::numbers::pi * std::pow(radius, 4)); }

double ToyStar::Density(double r) const {
  return r < radius ? CentralForce() / (4 * k) * (radius * radius - r * r) : 0;
}

DensityErrors CompareDensity(const ToyStar& star, std::span<const double> x, std::span<const double> y,
                             std::span<const double> density) {
  if (x.empty()) return {};
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double error = density[i] - star.Density(std::hypot(x[i], y[i]));
    sum += error * error;
  }
  const double mse = sum / static_cast<double>(x.size());
  return {mse, std::sqrt(mse) / star.Density(0)};
}

}  // namespace sph
