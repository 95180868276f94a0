#include "sph/plain_delta_twins.hpp"

#include <cmath>

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

std::vector<PlainSum> PlainDensityRates(const Cloud& cloud, const PlainWater& water) {
  std::vector<PlainSum> sums(cloud.Size());
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    const double rho = water.Density(i);
    ForNeighbours(cloud, i, water.h, [&](std::size_t j, Vec2 d, double r) {
      const double volume = cloud.mass[j] / water.Density(j);
      const double g = GradientAt(water.kernel, water.h, r);
      const Vec2 du = -1 * VelocityDifference(cloud, i, j);
      Add(sums[i], {rho * volume * g * Dot(du, d), 0});
      // psi.grad W = 2 (rho_j - rho_i) r_ji.grad W/r^2 - ..., and r_ji.grad W = -g r^2
      const double jump = -2 * (water.excess[j] - water.excess[i]) * g;
      const Vec2 gradients{water.gradient_x[i] + water.gradient_x[j], water.gradient_y[i] + water.gradient_y[j]};
      Add(sums[i], {water.diffusion * volume * jump, 0});
      Add(sums[i], {-water.diffusion * volume * g * Dot(gradients, d), 0});
    });
  }
  return sums;
}

std::vector<PlainSum> PlainWaterForces(const Cloud& cloud, const PlainWater& water) {
  std::vector<PlainSum> sums(cloud.Size());
  const SharpWeights weights = SharpWeightsOf(water.kernel);
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    const double rho = water.Density(i);
    const bool minus = water.tensile_control && water.pressure[i] < 0 && water.wholeness[i] > 0.75;
    ForNeighbours(cloud, i, water.h, [&](std::size_t j, Vec2 d, double r) {
      const double volume = cloud.mass[j] / water.Density(j);
      const Vec2 gradient = GradientAt(water.kernel, water.h, r) * d;
      const double s = r / (2 * water.h);
      const double sharp = weights.flat - weights.fall * s * s;
      const double pressure = water.pressure[j] + (minus ? -1 : 1) * water.pressure[i];
      Add(sums[i], -volume / rho * pressure * (water.sharp_gradient ? sharp : 1) * gradient);
      const Vec2 du = VelocityDifference(cloud, i, j);
      Add(sums[i], -2 * water.viscosity / rho * volume * sharp * GradientAt(water.kernel, water.h, r) * du);
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
    ForNeighbours(cloud, i, water.h, [&](std::size_t j, Vec2 d, double r) {
      const double volume = cloud.mass[j] / water.Density(j);
      const Vec2 gradient = GradientAt(water.kernel, water.h, r) * d;
      of.xx -= volume * d.x * gradient.x;
      of.xy -= volume * d.x * gradient.y;
      of.yy -= volume * d.y * gradient.y;
      Add(of.rise, volume * (water.excess[j] - water.excess[i]) * gradient);
      Add(of.fall, volume * (water.wholeness[j] - water.wholeness[i]) * gradient);
      const double ratio = ValueAt(water.kernel, water.h, r) / at_spacing;
      Add(of.lack, volume * (1 + 0.2 * std::pow(ratio, 4)) * gradient);
    });
    const double mean = 0.5 * (of.xx + of.yy), radius = std::hypot(0.5 * (of.xx - of.yy), of.xy);
    of.greatest = mean + radius;
    of.wholeness = mean - radius;
    const double determinant = of.xx * of.yy - of.xy * of.xy;
    const auto solved = [&](Vec2 b) {
      return Vec2{(of.yy * b.x - of.xy * b.y) / determinant, (of.xx * b.y - of.xy * b.x) / determinant};
    };
    of.gradient = solved(of.rise.value);
    of.wholeness_gradient = solved(of.fall.value);
  }
  return all;
}

}  // namespace sph
