#include "lab/lattice_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sph/kernels.hpp"

namespace sph {
namespace {

constexpr double kStep = 1e-5;  // of central differences, in smoothing lengths

template <typename Kernel, typename Slope>
RadialKernel Of(Slope slope) {
  const auto value = [](double q) { return Kernel(1).Value(q); };
  const auto curvature = [slope](double q) { return (slope(q + kStep) - slope(q - kStep)) / (2 * kStep); };
  return {Kernel::kSupport, value, slope, curvature};
}

template <typename Kernel>
RadialKernel FromGradient() {
  return Of<Kernel>([](double q) { return q < Kernel::kSupport ? q * Kernel(1).Gradient(q) : 0.0; });
}

/// A site of the lattice within the support, all in smoothing lengths, and what the sums take of it.
struct Site {
  Vec2 r;
  double value;       ///< W
  Vec2 gradient;      ///< grad W
  double xx, xy, yy;  ///< grad grad W
};

/// Half of the sites: the other half, at -r, gives the same again.
std::vector<Site> SitesOf(const RadialKernel& kernel, double h_over_spacing) {
  const double spacing = 1 / h_over_spacing;
  const int reach = static_cast<int>(kernel.support * h_over_spacing);
  std::vector<Site> sites;
  for (int row = 0; row <= reach; ++row) {
    for (int column = row == 0 ? 1 : -reach; column <= reach; ++column) {
      const Vec2 r{spacing * column, spacing * row};
      const double q = Length(r);
      if (q >= kernel.support) continue;
      const double slope = kernel.slope(q);
      const double bend = kernel.curvature(q) - slope / q;  // W'' - W'/q, along r
      const Vec2 n = (1 / q) * r;
      sites.push_back({r, kernel.value(q), slope * n, slope / q + bend * n.x * n.x, bend * n.x * n.y,
                       slope / q + bend * n.y * n.y});
    }
  }
  return sites;
}

/// Mass over density, in squares of the smoothing length.
double Cell(const RadialKernel& kernel, const std::vector<Site>& sites, double h_over_spacing, bool summed) {
  if (!summed) return 1 / (h_over_spacing * h_over_spacing);
  double sum = kernel.value(0);
  for (const Site& site : sites) sum += 2 * site.value;
  return 1 / sum;
}

/// S = sum grad W sin k.r over the whole lattice.
Vec2 SineSum(const std::vector<Site>& sites, Vec2 k) {
  Vec2 sum;
  for (const Site& site : sites) sum = sum + 2 * std::sin(Dot(k, site.r)) * site.gradient;
  return sum;
}

/// The greatest of `frequency2` over the wave vectors of the lattice's zone: on a grid, then on ever finer ones.
template <typename Frequency2>
double Greatest(double h_over_spacing, Frequency2 frequency2) {
  constexpr int kCells = 48;
  constexpr int kRefinements = 6;
  const double edge = std::numbers::pi * h_over_spacing;  // of the zone, times h
  Vec2 best;
  double greatest = 0;
  Box window{-edge, 0, edge, edge};
  for (int round = 0; round <= kRefinements; ++round) {
    for (int row = 0; row <= kCells; ++row) {
      for (int column = 0; column <= kCells; ++column) {
        const Vec2 k{window.x0 + column * window.Width() / kCells, window.y0 + row * window.Height() / kCells};
        const double value = frequency2(k);
        if (value > greatest) best = k;
        greatest = std::max(greatest, value);
      }
    }
    const double reach = 2 * std::max(window.Width(), window.Height()) / kCells;
    window = {best.x - reach, best.y - reach, best.x + reach, best.y + reach};
  }
  return std::sqrt(greatest);
}

}  // namespace

RadialKernel CubicSplineOfUnitLength() { return FromGradient<CubicSpline<2>>(); }
RadialKernel WendlandC2OfUnitLength() { return FromGradient<WendlandC2>(); }
RadialKernel WendlandC4OfUnitLength() { return FromGradient<WendlandC4>(); }
RadialKernel QuinticSplineOfUnitLength() { return FromGradient<QuinticSpline>(); }
RadialKernel Poly6OfUnitLength() {
  return Of<Poly6>([](double q) { return (Poly6(1).Value(q + kStep) - Poly6(1).Value(q - kStep)) / (2 * kStep); });
}
RadialKernel SpikyOfUnitLength() {
  return Of<Spiky>([](double q) { return Spiky(1).Slope(q); });
}

namespace {

/// M of a lattice.
class WaveMatrix {
 public:
  WaveMatrix(const RadialKernel& kernel, const LatticeWaves& waves)
      : sites_(SitesOf(kernel, waves.h_over_spacing)),
        cell_(Cell(kernel, sites_, waves.h_over_spacing, waves.summed)),
        chi_(waves.pressure) {}

  /// The two eigenvalues, the lesser first.
  std::pair<double, double> At(Vec2 k) const {
    const Vec2 s = SineSum(sites_, k);
    const double longitudinal = cell_ * cell_ * (1 - 2 * chi_);
    double xx = longitudinal * s.x * s.x, xy = longitudinal * s.x * s.y, yy = longitudinal * s.y * s.y;
    for (const Site& site : sites_) {
      const double weight = 2 * cell_ * chi_ * 2 * (1 - std::cos(Dot(k, site.r)));
      xx += weight * site.xx;
      xy += weight * site.xy;
      yy += weight * site.yy;
    }
    const double mean = 0.5 * (xx + yy), apart = std::hypot(0.5 * (xx - yy), xy);
    return {mean - apart, mean + apart};
  }

 private:
  std::vector<Site> sites_;
  double cell_;
  double chi_;
};

}  // namespace

double GreatestFrequency(const RadialKernel& kernel, const LatticeWaves& waves) {
  const WaveMatrix matrix(kernel, waves);
  return Greatest(waves.h_over_spacing, [&](Vec2 k) { return matrix.At(k).second; });
}

double GreatestGrowth(const RadialKernel& kernel, const LatticeWaves& waves) {
  const WaveMatrix matrix(kernel, waves);
  return Greatest(waves.h_over_spacing, [&](Vec2 k) { return -matrix.At(k).first; });
}

namespace {

double GreatestOfMueller(const RadialKernel& density, const RadialKernel& pressure, double h_over_spacing,
                         double sign) {
  const std::vector<Site> of_density = SitesOf(density, h_over_spacing);
  const std::vector<Site> of_pressure = SitesOf(pressure, h_over_spacing);
  const double cell = Cell(density, of_density, h_over_spacing, true);
  return Greatest(h_over_spacing, [&](Vec2 k) {
    return sign * 0.5 * cell * cell * Dot(SineSum(of_density, k), SineSum(of_pressure, k));
  });
}

}  // namespace

double GreatestFrequency(const RadialKernel& density, const RadialKernel& pressure, double h_over_spacing) {
  return GreatestOfMueller(density, pressure, h_over_spacing, 1);
}

double GreatestGrowth(const RadialKernel& density, const RadialKernel& pressure, double h_over_spacing) {
  return GreatestOfMueller(density, pressure, h_over_spacing, -1);
}

}  // namespace sph
