#include "sph/plain_delta_twins.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/kernels.hpp"
#include "sph/quadrature.hpp"

namespace sph {
namespace {

/// Calls with(j, x_i - x_j, r) for every particle j nearer to i than 2h, i included.
template <typename With>
void ForNeighbours(const Cloud& cloud, std::size_t i, double h, With with) {
  for (std::size_t j = 0; j < cloud.Size(); ++j) {
    const Vec2 d{cloud.x[i] - cloud.x[j], cloud.y[i] - cloud.y[j]};
    if (Length(d) < 2 * h) with(j, d, Length(d));
  }
}

void Add(PlainSum& sum, Vec2 term) {
  sum.value = sum.value + term;
  sum.size += std::abs(term.x) + std::abs(term.y);
  ++sum.terms;
}

Vec2 VelocityDifference(const Cloud& cloud, std::size_t i, std::size_t j) {
  return {cloud.vx[j] - cloud.vx[i], cloud.vy[j] - cloud.vy[i]};
}

}  // namespace

double ValueAt(SmoothingKernel kernel, double h, double r) {
  if (kernel == SmoothingKernel::kQuintic) return QuinticSpline(2 * h / 3).Value(r);
  return kernel == SmoothingKernel::kWendlandC2 ? WendlandC2(h).Value(r) : WendlandC4(h).Value(r);
}

double GradientAt(SmoothingKernel kernel, double h, double r) {
  if (kernel == SmoothingKernel::kQuintic) return QuinticSpline(2 * h / 3).Gradient(r);
  return kernel == SmoothingKernel::kWendlandC2 ? WendlandC2(h).Gradient(r) : WendlandC4(h).Gradient(r);
}

std::vector<PlainSum> PlainGasDensity(SmoothingKernel kernel, const Cloud& cloud, double h) {
  std::vector<PlainSum> sums(cloud.Size());
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    ForNeighbours(cloud, i, h, [&](std::size_t j, Vec2, double r) {
      Add(sums[i], {cloud.mass[j] * ValueAt(kernel, h, r), 0});
    });
  }
  return sums;
}

std::vector<PlainSum> PlainGasPressure(SmoothingKernel kernel, const Cloud& cloud, std::span<const double> term,
                                       double h) {
  std::vector<PlainSum> sums(cloud.Size());
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    ForNeighbours(cloud, i, h, [&](std::size_t j, Vec2 d, double r) {
      Add(sums[i], -cloud.mass[j] * (term[i] + term[j]) * GradientAt(kernel, h, r) * d);
    });
  }
  return sums;
}

SharpWeights SharpWeightsOf(SmoothingKernel kernel) {
  const auto moment = [&](int power) {  // of -W'/r over the plane, with s = r/2h
    return Integral([&](double s) { return -GradientAt(kernel, 0.5, s) * std::pow(s, power + 1); }, 0, 1, 42);
  };
  // a m2 - b m4 = m2 and a m4 - b m6 = 0
  const double m2 = moment(2), m4 = moment(4), m6 = moment(6);
  const double flat = m2 / (m2 - m4 * m4 / m6);
  return {flat, flat * m4 / m6};
}

double VarianceOf(SmoothingKernel kernel, double h) {
  // (x^2 + y^2)/2 over the plane, with s = r/2h
  const auto moment = [&](double s) { return std::numbers::pi * s * s * s * ValueAt(kernel, 0.5, s); };
  return 4 * h * h * Integral(moment, 0, 1, 42);
}

double ViscousWeightAt(double h, double r) {
  const double support = 2 * h, s = r / support;
  const double flat = SepticSpline::kFlat - SepticSpline::kFall * s * s;
  // Below a 256th of the support the weights fall to 0, before round-off counts.
  return r == 0 ? 0 : -SepticSpline(support / 4).Gradient(r) * std::min(1.0, 256 * s) * flat;
}

namespace {

/// sum_j V_j a_j (x) grad W: a 2 x 2 matrix.
struct Matrix {
  double xx = 0, xy = 0, yx = 0, yy = 0;

  void Add(double volume, Vec2 a, Vec2 gradient) {
    xx += volume * a.x * gradient.x;
    xy += volume * a.x * gradient.y;
    yx += volume * a.y * gradient.x;
    yy += volume * a.y * gradient.y;
  }
  double Determinant() const { return xx * yy - xy * yx; }
  /// Eigenvalues if it is symmetric.
  double Greatest() const { return 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy); }
  double Least() const { return 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy); }
};

}  // namespace

std::vector<PlainRates> PlainDensityRates(const Cloud& cloud, const PlainWater& water) {
  std::vector<PlainRates> all(cloud.Size());
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    PlainRates& of = all[i];
    const double rho = water.Density(i);
    PlainSum expansion;
    Matrix places, velocities;
    double squares = 0;
    ForNeighbours(cloud, i, water.h, [&](std::size_t j, Vec2 d, double r) {
      const double volume = cloud.mass[j] / water.Density(j);
      const double g = GradientAt(water.kernel, water.h, r);
      const Vec2 du = VelocityDifference(cloud, i, j);
      Add(expansion, {-rho * volume * g * Dot(du, d), 0});
      places.Add(volume, -1 * d, g * d);
      velocities.Add(volume, du, g * d);
      squares -= volume * g * std::pow(Dot(du, d), 2);
      // psi.grad W = 2 (rho_j - rho_i) r_ji.grad W/r^2 - ..., and r_ji.grad W = -g r^2
      const double jump = -2 * (water.excess[j] - water.excess[i]) * g;
      const Vec2 gradients{water.gradient_x[i] + water.gradient_x[j], water.gradient_y[i] + water.gradient_y[j]};
      Add(of.rate, {water.diffusion * volume * jump, 0});
      Add(of.rate, {-water.diffusion * volume * g * Dot(gradients, d), 0});
    });
    of.strain = std::sqrt(squares / water.variance);
    of.wholeness = places.Least();
    of.greatest = places.Greatest();
    of.rate.size += expansion.size;
    if (of.wholeness > 0.75) {
      // The trace of velocities times the inverse of places.
      const double trace =
          velocities.xx * places.yy - velocities.xy * places.yx - velocities.yx * places.xy + velocities.yy * places.xx;
      of.rate.value.x -= rho * trace / places.Determinant();
    } else {
      of.rate.value.x += expansion.value.x;
    }
  }
  return all;
}

std::vector<PlainSum> PlainWaterForces(const Cloud& cloud, const PlainWater& water) {
  std::vector<PlainSum> sums(cloud.Size());
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    const double rho = water.Density(i);
    const bool minus = water.tensile_control && water.pressure[i] < 0 && water.wholeness[i] > 0.75;
    ForNeighbours(cloud, i, water.h, [&](std::size_t j, Vec2 d, double r) {
      const double volume = cloud.mass[j] / water.Density(j);
      const Vec2 gradient = GradientAt(water.kernel, water.h, r) * d;
      const double s = r / (2 * water.h);
      const double bracket = water.gradient_flat - water.gradient_fall * s * s;
      const double pressure = water.pressure[j] + (minus ? -1 : 1) * water.pressure[i];
      Add(sums[i], -volume / rho * pressure * bracket * gradient);
      const Vec2 du = VelocityDifference(cloud, i, j);
      Add(sums[i], 2 * water.viscosity / rho * volume * ViscousWeightAt(water.h, r) * du);
      if (r > 0) Add(sums[i], water.artificial / rho * volume * Dot(du, -1 * d) / (r * r) * gradient);
    });
  }
  return sums;
}

std::vector<PlainSurroundings> SurroundingsOf(const Cloud& cloud, const PlainWater& water) {
  std::vector<PlainSurroundings> all(cloud.Size());
  const double at_spacing = ValueAt(water.kernel, water.h, water.spacing);
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    PlainSurroundings& of = all[i];
    Matrix places;
    ForNeighbours(cloud, i, water.h, [&](std::size_t j, Vec2 d, double r) {
      const double volume = cloud.mass[j] / water.Density(j);
      const Vec2 gradient = GradientAt(water.kernel, water.h, r) * d;
      places.Add(volume, -1 * d, gradient);
      Add(of.rise, volume * (water.excess[j] - water.excess[i]) * gradient);
      Add(of.fall, volume * (water.wholeness[j] - water.wholeness[i]) * gradient);
      const double value = ValueAt(water.kernel, water.h, r);
      Add(of.lack, volume * (1 + 0.2 * std::pow(value / at_spacing, 4)) * gradient);
      Add(of.near, volume * std::max(0.0, 1 - std::pow(r / (0.7 * water.spacing), 2)) * gradient);
      of.concentration += volume * value;
    });
    of.greatest = places.Greatest();
    of.wholeness = places.Least();
    const auto solved = [&](Vec2 b) {
      return (1 / places.Determinant()) * Vec2{places.yy * b.x - places.xy * b.y, places.xx * b.y - places.xy * b.x};
    };
    of.gradient = solved(of.rise.value);
    of.wholeness_gradient = solved(of.fall.value);
  }
  return all;
}

}  // namespace sph
