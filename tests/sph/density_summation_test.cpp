// Density by the passes on vectors against the sum over all pairs, and against what a lattice's Fourier series says.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "sph/cluster_passes.hpp"
#include "sph/kernels.hpp"
#include "sph/plain_twins.hpp"
#include "sph/quadrature.hpp"

namespace sph {
namespace {

using Pass = decltype(&ComputeCubicSplineDensity<double>);

template <typename Real>
std::vector<double> DensityOf(Neighbourhood<Real>& found, void (*pass)(const PassInput<Real>&, ListBlock&, Real*)) {
  std::vector<Real> density(found.cloud.Size() + kPadding, -1);
  for (ListBlock& block : found.search.Blocks()) pass(found.Input(), block, density.data());
  return {density.begin(), density.end() - kPadding};
}

template <typename Real>
void ExpectNearTwin(const Cloud& cloud, const std::vector<double>& density, const std::vector<PlainSum>& plain) {
  double greatest = 0;
  for (const PlainSum& sum : plain) greatest = std::max(greatest, sum.value.x);
  for (std::size_t i = 0; i < cloud.Size(); ++i) {
    ASSERT_NEAR(density[i], plain[i].value.x, kTolerance<Real> * greatest) << cloud.name << ", particle " << i;
  }
}

template <typename Real>
class DensitySummation : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(DensitySummation, BothPrecisions);

TYPED_TEST(DensitySummation, WithTheCubicSplineEqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
      ExpectNearTwin<TypeParam>(found.cloud, DensityOf(found, &ComputeCubicSplineDensity<TypeParam>),
                                PlainDensity(found.cloud, kCloudH));
    }
  });
}

TYPED_TEST(DensitySummation, WithPoly6EqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      auto found = FindNeighbours<TypeParam>(cloud, kCloudH);
      ExpectNearTwin<TypeParam>(found.cloud, DensityOf(found, &ComputePoly6Density<TypeParam>),
                                PlainPoly6Density(found.cloud, kCloudH));
    }
  });
}

TYPED_TEST(DensitySummation, OfEqualMassesIsThatOfMassesOneByOne) {
  for (Cloud cloud : AllClouds()) {
    cloud.mass.assign(cloud.Size(), 0.75 * kCloudH * kCloudH);
    auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
    PassInput<TypeParam> equal = found.Input();
    equal.mass = nullptr;
    equal.equal_mass = 0.75 * kCloudH * kCloudH;
    std::vector<TypeParam> density(cloud.Size() + kPadding);
    for (ListBlock& block : found.search.Blocks()) ComputeCubicSplineDensity(equal, block, density.data());
    ExpectNearTwin<TypeParam>(found.cloud, {density.begin(), density.end()}, PlainDensity(found.cloud, kCloudH));
  }
}

TYPED_TEST(DensitySummation, OfALoneParticleIsItsMassTimesTheKernelsMiddle) {
  Cloud cloud;
  cloud.x = cloud.y = cloud.vx = cloud.vy = {0};
  cloud.mass = {0.25};
  const double expected = 0.25 * CubicSpline<2>(kCloudH).Value(0);
  auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
  EXPECT_NEAR(DensityOf(found, &ComputeCubicSplineDensity<TypeParam>)[0], expected, kTolerance<TypeParam> * expected);
}

/// rho of an endless square lattice of unit density by Poisson's summation formula: the sum over the reciprocal lattice
/// of the kernel's Fourier transform What(K) = 2 pi int W(r) J0(K r) r dr.
template <typename Kernel>
double LatticeDensityByFourierSeries(const Kernel& kernel, double support, double spacing) {
  const auto transform = [&](double wave_number) {
    const auto ring = [&](double r) {
      return 2 * std::numbers::pi * r * kernel.Value(r) * std::cyl_bessel_j(0.0, wave_number * r);
    };
    return Integral(ring, 0, support / 2, 40) + Integral(ring, support / 2, support, 40);
  };
  constexpr int kOrders = 12;
  double sum = transform(0);
  for (int i = 1; i <= kOrders; ++i) {  // a quarter of the reciprocal lattice: the others are the same by symmetry
    for (int j = 0; j <= kOrders; ++j) sum += 4 * transform(2 * std::numbers::pi / spacing * std::hypot(i, j));
  }
  return sum;
}

/// The density in the middle of a square lattice that is wide enough, with mass spacing^2 a particle: 1 but for the
/// kernel's error.
double LatticeDensityBySummation(Pass pass, double support, double spacing) {
  Cloud cloud;
  constexpr int kHalf = 5;
  for (int row = -kHalf; row <= kHalf; ++row) {
    for (int column = -kHalf; column <= kHalf; ++column) {
      cloud.x.push_back(column * spacing);
      cloud.y.push_back(row * spacing);
    }
  }
  cloud.vx = cloud.vy = cloud.x;
  cloud.mass.assign(cloud.Size(), spacing * spacing);
  auto found = FindNeighbours<double>(cloud, support);
  const auto density = DensityOf(found, pass);
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (found.cloud.x[i] == 0 && found.cloud.y[i] == 0) return density[i];
  }
  return 0;
}

TEST(LatticeDensity, IsWhatItsFourierSeriesSays) {
  // The series is cut off after 12 orders. The kernel's third derivative jumps, so What falls as K^-4.5, and what is
  // left out is below 1e-6; the two sums have nothing in common but the kernel.
  for (const double spacings : {1.0, 1.2, 1.5, 2.0}) {
    const double dx = kCloudH / spacings;
    const CubicSpline<2> kernel(kCloudH);
    EXPECT_NEAR(LatticeDensityBySummation(&ComputeCubicSplineDensity<double>, 2 * kCloudH, dx),
                LatticeDensityByFourierSeries(kernel, 2 * kCloudH, dx), 2e-6)
        << "h = " << spacings << " spacings";
  }
  const Poly6 poly6(kCloudH);
  const double dx = kCloudH / 1.75;  // the tutorial's ratio, put right: 0.16 m over 0.0913 m
  EXPECT_NEAR(LatticeDensityBySummation(&ComputePoly6Density<double>, kCloudH, dx),
              LatticeDensityByFourierSeries(poly6, kCloudH, dx), 2e-6);
}

TEST(LatticeDensity, IsTheFluidsDensity) {
  // What is left is What at the first reciprocal vectors, 4 What(2 pi/dx): measured as 0.3 % at its worst for these h.
  for (const double spacings : {1.2, 1.5, 2.0}) {
    EXPECT_NEAR(LatticeDensityBySummation(&ComputeCubicSplineDensity<double>, 2 * kCloudH, kCloudH / spacings), 1, 5e-3)
        << spacings;
  }
}

template <typename Real>
void ExpectThatTheFirstPassShortensTheLists(const Cloud& cloud) {
  Neighbourhood<Real> found = FindNeighbours<Real>(cloud, 2 * kCloudH);
  const std::vector<double> first = DensityOf(found, ComputeCubicSplineDensity<Real>);
  const Cloud& p = found.cloud;
  const auto near = [&](std::uint32_t i, std::uint32_t j, double by) {
    return std::hypot(p.x[i] - p.x[j], p.y[i] - p.y[j]) < by;
  };
  for (const ListBlock& block : std::as_const(found.search).Blocks()) {
    EXPECT_FALSE(block.coarse);
    for (std::uint32_t k = block.first; k < block.last; ++k) {
      const Cluster& cluster = found.search.Clusters()[k];
      const auto list = block.Of(k);
      const double reach = found.support * static_cast<double>(block.reach[k - block.first]);
      std::vector<bool> listed(p.Size());
      for (const std::uint32_t j : list) listed[j] = true;
      for (std::uint32_t j = 0; j < p.Size(); ++j) {
        bool within = false;
        // Lanes beyond the end of a cluster are of the next one, or of none: they may keep a particle, but drop none.
        for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i)
          within |= near(i, j, found.support);
        if (within) {
          ASSERT_TRUE(listed[j]) << cloud.name << ": " << j << " near cluster " << k;
        }
        bool within_round_off = cluster.count < static_cast<std::uint32_t>(Lanes<Real>());
        for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
          within_round_off |= near(i, j, reach * (1 + 1e-5));
        }
        if (listed[j]) {
          ASSERT_TRUE(within_round_off) << cloud.name << ": " << j << " far from cluster " << k;
        }
      }
    }
  }
  EXPECT_EQ(DensityOf(found, ComputeCubicSplineDensity<Real>), first) << "what was dropped adds nothing";
}

TEST(DensitySummation, ShortensCoarseListsToWhatIsWithinReachOfAParticle) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      ExpectThatTheFirstPassShortensTheLists<float>(cloud);
      ExpectThatTheFirstPassShortensTheLists<double>(cloud);
    }
  });
}

}  // namespace
}  // namespace sph
