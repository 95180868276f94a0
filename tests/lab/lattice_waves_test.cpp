// The theory of the longest step: sums over a lattice against the kernel's Fourier transform, against differences of
// the system's own accelerations, and against the published figures.
#include "lab/lattice_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "particles/diagnostics.hpp"
#include "sph/given_system.hpp"

namespace sph {
namespace {

double LiquidLimit(const RadialKernel& kernel, double eta) { return StableStep(GreatestFrequency(kernel, {eta, 0})); }
double GasLimit(const RadialKernel& kernel, double eta) { return StableStep(GreatestFrequency(kernel, {eta, 0.5})); }

/// 2/max(k h What(k)), What = 2 pi int W J0(k r) r dr, by Simpson's rule: many neighbours are a continuum.
double ContinuumLimit(const RadialKernel& kernel) {
  constexpr int kIntervals = 400;
  double greatest = 0;
  for (double k = 0.2; k < 5; k += 0.005) {
    double sum = 0;
    for (int i = 0; i <= kIntervals; ++i) {
      const double q = kernel.support * i / kIntervals;
      const double weight = i == 0 || i == kIntervals ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight * kernel.value(q) * std::cyl_bessel_j(0, k * q) * q;
    }
    greatest = std::max(greatest, k * 2 * std::numbers::pi * sum * kernel.support / kIntervals / 3);
  }
  return 2 / greatest;
}

TEST(LatticeWaves, OfManyNeighboursAreThoseOfTheKernelsFourierTransform) {
  for (const RadialKernel& kernel : {CubicSplineOfUnitLength(), WendlandC2OfUnitLength(), WendlandC4OfUnitLength()}) {
    const double continuum = ContinuumLimit(kernel);
    EXPECT_NEAR(LiquidLimit(kernel, 5), continuum, 1e-3 * continuum);
  }
}

TEST(LatticeWaves, GiveTheFiguresThatLeapfrogIsKnownToStopAt) {
  // Of liquids for many neighbours, independent of their number within 3 %.
  EXPECT_NEAR(LiquidLimit(CubicSplineOfUnitLength(), 5), 1.88, 0.005);
  EXPECT_NEAR(LiquidLimit(WendlandC2OfUnitLength(), 5), 1.76, 0.005);
  EXPECT_NEAR(LiquidLimit(WendlandC4OfUnitLength(), 5), 1.53, 0.005);
  EXPECT_NEAR(LiquidLimit(WendlandC2OfUnitLength(), 1.3), 1.810, 0.0005);
  // Of gases with P = k rho^2.
  EXPECT_NEAR(GasLimit(WendlandC2OfUnitLength(), 2), 1.25, 0.01);
  EXPECT_NEAR(GasLimit(WendlandC4OfUnitLength(), 2), 1.09, 0.005);
  for (const double eta : {1.2, 1.3, 1.5, 1.75, 2.0}) {
    EXPECT_GT(GasLimit(CubicSplineOfUnitLength(), eta), 1.30) << eta;
    EXPECT_LT(GasLimit(CubicSplineOfUnitLength(), eta), 1.39) << eta;
  }
}

TEST(LatticeWaves, OfStillWaterDoNotGrow) {
  // Scene still-water has the quintic spline and, at its floor, P/(rho c^2) = 1/400; with more neighbours rows slide.
  const RadialKernel kernel = QuinticSplineOfUnitLength();
  EXPECT_EQ(GreatestGrowth(kernel, {0.94, 1.0 / 400}), 0);
  EXPECT_GT(GreatestGrowth(kernel, {1.065, 1.0 / 400}), 0.005);
}

/// The paper's gas on a periodic lattice, of which one wave displaces the particles a little.
class WavyGas : public ParticleSystemSPH {
 public:
  static constexpr int kAcross = 20;
  WavyGas(double eta, Vec2 k, Vec2 direction) : ParticleSystemSPH(Base(), Gas(eta)), k_(k), direction_(direction) {
    Reset();
  }

  /// -a/u along the displacement, which is omega^2 where the wave is one of the lattice's own.
  double Stiffness() const {
    const Particles& p = State();
    double stiffness = 0, squares = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const Vec2 u = Displacement({p.id[i] % kAcross + 0.5, p.id[i] / kAcross + 0.5});
      stiffness -= p.ax[i] * u.x + p.ay[i] * u.y;
      squares += Dot(u, u);
    }
    return stiffness / squares;
  }

 protected:
  void InitialPositions() override {
    for (int row = 0; row < kAcross; ++row) {
      for (int column = 0; column < kAcross; ++column) {
        const Vec2 site{column + 0.5, row + 0.5};
        particles_.Add(site + Displacement(site), {}, 1);
      }
    }
  }

 private:
  Vec2 Displacement(Vec2 site) const { return 1e-5 * std::sin(Dot(k_, site) + 0.3) * direction_; }
  static Parameters Base() {
    Parameters base = NoForces();
    base.fluid.particles = kAcross * kAcross;
    base.fluid.region.box = {0, 0, kAcross, kAcross};
    return base;
  }
  static ParametersSPH Gas(double eta) {
    ParametersSPH gas{eta, Polytrope{0.5}};
    gas.periods = {{0, 0, kAcross, kAcross}, true, true};
    return gas;
  }

  Vec2 k_, direction_;
};

TEST(LatticeWaves, AreThoseOfTheSystemsOwnAccelerations) {
  constexpr double kEta = 1.3;
  double greatest = 0;
  for (int n = 1; n <= WavyGas::kAcross / 2; ++n) {
    const double k = 2 * std::numbers::pi * n / WavyGas::kAcross;
    for (const auto& [wave, direction] : {std::pair{Vec2{k, 0}, Vec2{1, 0}}, std::pair{Vec2{k, 0}, Vec2{0, 1}},
                                          std::pair{Vec2{k, k}, std::sqrt(0.5) * Vec2{1, 1}}}) {
      greatest = std::max(greatest, WavyGas(kEta, wave, direction).Stiffness());
    }
  }
  // P = rho^2/2: c^2 is the density that the sum over the lattice gives.
  const double sound2 = Diagnose(WavyGas(kEta, {}, {})).density.mean;
  const double measured = std::sqrt(greatest / sound2) * kEta;  // omega h/c
  const double theory = GreatestFrequency(CubicSplineOfUnitLength(), {kEta, 0.5, true});
  EXPECT_LE(measured, 1.0001 * theory);
  EXPECT_GE(measured, 0.99 * theory) << "the greatest is nearly one of these waves";
}

TEST(LatticeWaves, SayWhichLatticesPairOrGiveWay) {
  // The cubic spline pairs where neighbours are many; Wendland's kernels do not.
  EXPECT_GT(GreatestGrowth(CubicSplineOfUnitLength(), {1.5, 0.5}), 0.3);
  EXPECT_EQ(GreatestGrowth(CubicSplineOfUnitLength(), {1.2, 0.5}), 0);
  EXPECT_LT(GreatestGrowth(WendlandC2OfUnitLength(), {2.0, 0.5}), 0.02);
  // Without pressure nothing leaves its place.
  EXPECT_LT(GreatestGrowth(CubicSplineOfUnitLength(), {1.5, 0}), 1e-6);
}

}  // namespace
}  // namespace sph
