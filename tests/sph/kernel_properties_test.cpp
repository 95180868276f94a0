// What is known of the accurate solver's kernels, found again by quadrature and by waves on lattices; and the steps
// that its limits allow, against those that leapfrog keeps on lattices.
#include "sph/kernel_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "sph/delta.hpp"
#include "sph/given_system.hpp"
#include "sph/plain_delta_twins.hpp"
#include "sph/quadrature.hpp"

namespace sph {
namespace {

using std::numbers::pi;

// Here lengths are in half support radii, and the speed of sound is 1.
constexpr double kSpacings[] = {1 / 1.6, 1 / 1.8, 1 / 2.0, 1 / 2.2, 1 / 2.4, 1 / 2.6, 1 / 2.8};

/// A square or hexagonal lattice, each site with the area of a square of the spacing.
class Lattice {
 public:
  Lattice(double spacing, bool hexagonal)
      : area_(spacing * spacing),
        a_{hexagonal ? spacing * std::sqrt(2 / std::numbers::sqrt3) : spacing, 0},
        b_(hexagonal ? Vec2{0.5 * a_.x, area_ / a_.x} : Vec2{0, spacing}) {
    const int most = static_cast<int>(3 / spacing) + 2;
    for (int row = -most; row <= most; ++row) {
      for (int column = -most; column <= most; ++column) {
        const Vec2 site = column * a_ + row * b_;
        if (Length(site) < 2 && (row != 0 || column != 0)) sites_.push_back(site);
      }
    }
  }

  /// Sum over the sites but the origin of area times term(site).
  template <typename Term>
  double Sum(Term term) const {
    double sum = 0;
    for (const Vec2 site : sites_) sum += area_ * term(site);
    return sum;
  }
  /// Calls with(k) for wave vectors of a grid over the cell of the reciprocal lattice, but for 0.
  template <typename With>
  void ForWaves(With with) const {
    constexpr int kGrid = 24;
    for (int m = 0; m <= kGrid / 2; ++m) {  // the others are minus these
      for (int n = 0; n < kGrid; ++n) {
        const double s = 2 * pi * m / kGrid, t = 2 * pi * n / kGrid;  // k.a and k.b
        if (m != 0 || n != 0) with(Vec2{s / a_.x, (t - s * b_.x / a_.x) / b_.y});
      }
    }
  }

 private:
  double area_;
  Vec2 a_, b_;
  std::vector<Vec2> sites_;
};

double Push(SmoothingKernel kernel, double r) { return -GradientAt(kernel, 1, r); }

/// The least over the spacings of 1/max over waves of measure(lattice, k).
double LeastStep(bool hexagonal, const std::function<double(const Lattice&, Vec2)>& measure) {
  double greatest = 0;
  for (const double spacing : kSpacings) {
    const Lattice lattice(spacing, hexagonal);
    lattice.ForWaves([&](Vec2 k) { greatest = std::max(greatest, measure(lattice, k)); });
  }
  return 1 / greatest;
}

double Spread(const Lattice& lattice, Vec2 k, const std::function<double(double)>& weight) {
  return lattice.Sum([&](Vec2 x) { return weight(Length(x)) * (1 - std::cos(Dot(k, x))); });
}

TEST(KernelProperties, MomentsAreThoseOfQuadrature) {
  for (const SmoothingKernel kernel : kAllKernels) {
    const KernelProperties& known = PropertiesOf(kernel);
    const SharpWeights weights = SharpWeightsOf(kernel);
    SCOPED_TRACE(known.name);
    EXPECT_NEAR(known.variance, VarianceOf(kernel, 0.5), 1e-12);
    EXPECT_NEAR(known.flat, weights.flat, 1e-11);
    EXPECT_NEAR(known.fall, weights.fall, 1e-10);
  }
}

TEST(KernelProperties, StepsOfSoundAreThoseOfTheKernelsTransform) {
  for (const SmoothingKernel kernel : kAllKernels) {
    // Sound of a liquid has omega = c K What(K), as both its gradients are smoothed once; with sharp weights in one of
    // them c K sqrt(What(K) S(K)), K S = 2 pi int -W' (flat - fall s^2) J1(K r) r dr; that of P = rho c^2/2, whose
    // density is a sum, c K sqrt(What(K)).
    const SharpWeights weights = SharpWeightsOf(kernel);
    double of_water = 0, of_sharp = 0, of_gas = 0;
    for (double k = 0.1; k < 8; k += 0.02) {
      const auto wave = [&](double r) { return ValueAt(kernel, 1, r) * std::cyl_bessel_j(0.0, k * r) * 2 * pi * r; };
      const double transform = Integral(wave, 0, 2, 12);
      const auto slope = [&](double r) {
        return -GradientAt(kernel, 1, r) * (weights.flat - weights.fall * r * r / 4) * std::cyl_bessel_j(1.0, k * r) *
               2 * pi * r * r;
      };
      of_water = std::max(of_water, k * transform);
      of_sharp = std::max(of_sharp, std::sqrt(std::max(0.0, k * transform * Integral(slope, 0, 2, 12))));
      of_gas = std::max(of_gas, k * std::sqrt(std::max(0.0, transform)));
    }
    const KernelProperties& known = PropertiesOf(kernel);
    SCOPED_TRACE(known.name);
    EXPECT_NEAR(known.water_step / (2 / of_water), 1, 0.01);  // known to three digits, of which the last is not sure
    EXPECT_NEAR(known.sharp_step / (2 / of_sharp), 1, 0.01);
    EXPECT_NEAR(known.gas_step / (2 / of_gas), 1, 0.01);
  }
}

TEST(KernelProperties, SpreadsAreTheLeastOfWavesOnSquareLattices) {
  for (const SmoothingKernel kernel : kAllKernels) {
    const KernelProperties& known = PropertiesOf(kernel);
    SCOPED_TRACE(known.name);
    const double least = LeastStep(false, [&](const Lattice& lattice, Vec2 k) {
      return Spread(lattice, k, [&](double r) { return Push(kernel, r); });
    });
    EXPECT_LE(known.spread, least);
    EXPECT_GT(known.spread, 0.999 * least);
    const double along = LeastStep(false, [&](const Lattice& lattice, Vec2 k) {
      const auto part = [&](auto of) {
        return lattice.Sum(
            [&](Vec2 x) { return Push(kernel, Length(x)) * of(x) / Dot(x, x) * (1 - std::cos(Dot(k, x))); });
      };
      const double xx = part([](Vec2 x) { return x.x * x.x; }), yy = part([](Vec2 x) { return x.y * x.y; });
      const double xy = part([](Vec2 x) { return x.x * x.y; });
      return 0.5 * (0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy));
    });
    EXPECT_LE(known.along_spread, along);
    EXPECT_GT(known.along_spread, 0.95 * along);  // two digits
  }
}

/// The sums of the named lattice that are 1 in a continuum, for a support of `reach` spacings.
LatticeSums SumsOf(SmoothingKernel kernel, double reach, bool hexagonal) {
  const Lattice lattice(2 / reach, hexagonal);
  const SharpWeights weights = SharpWeightsOf(kernel);
  LatticeSums sums;
  const double own = 4 / (reach * reach) * ValueAt(kernel, 1, 0);
  sums.concentration = own + lattice.Sum([&](Vec2 x) { return ValueAt(kernel, 1, Length(x)); });
  sums.second_order = lattice.Sum([&](Vec2 x) { return Push(kernel, Length(x)) * x.x * x.x; });
  sums.fourth_order = lattice.Sum(
      [&](Vec2 x) { return Push(kernel, Length(x)) * x.x * x.x * (weights.flat - weights.fall * Dot(x, x) / 4); });
  return sums;
}

TEST(LatticeSums, AreTheMeanOverSquareAndHexagonalLattices) {
  for (const SmoothingKernel kernel : kAllKernels) {
    for (const double reach : {2.6, 3.2, 4.0, 5.6}) {
      const LatticeSums found = SumsOnLattices(kernel, reach);
      const LatticeSums square = SumsOf(kernel, reach, false), hexagonal = SumsOf(kernel, reach, true);
      SCOPED_TRACE(std::string(PropertiesOf(kernel).name) + ", " + std::to_string(reach));
      EXPECT_NEAR(found.concentration, 0.5 * (square.concentration + hexagonal.concentration), 1e-12);
      EXPECT_NEAR(found.second_order, 0.5 * (square.second_order + hexagonal.second_order), 1e-12);
      EXPECT_NEAR(found.fourth_order, 0.5 * (square.fourth_order + hexagonal.fourth_order), 1e-10);
    }
  }
}

TEST(LatticeSums, TendToOneWithMoreNeighboursAndAreOneWhereTheyTellNothing) {
  for (const SmoothingKernel kernel : kAllKernels) {
    const LatticeSums many = SumsOnLattices(kernel, 19.9);
    for (const double sum : {many.concentration, many.second_order, many.fourth_order}) EXPECT_NEAR(sum, 1, 1e-4);
    for (const double reach : {1.9, 20.1, std::nan("")}) {
      const LatticeSums none = SumsOnLattices(kernel, reach);
      for (const double sum : {none.concentration, none.second_order, none.fourth_order}) EXPECT_EQ(sum, 1);
    }
  }
}

/// A liquid at rest whose speed of sound and half support radius are 1.
struct Liquid {
  Parameters base = NoForces();
  ParametersSPH sph;

  explicit Liquid(SmoothingKernel kernel) {
    sph.smoothing_length = 2 / SupportOf(kernel);
    sph.equation_of_state = IdealGas{1, 1};
    sph.delta = {.kernel = kernel, .diffusion = 0};
  }
  std::vector<StepLimit> Limits() const {
    Delta system(base, sph);
    system.Reset();
    return system.StepLimits();
  }
};

const StepLimit& Named(const std::vector<StepLimit>& limits, const std::string& what) {
  return *std::ranges::find(limits, what, &StepLimit::what);
}

TEST(StepLimits, OfAccuracyHoldByThemselves) {
  const StepLimit swings{"a", 1}, lax{"b", 1.1, LimitKind::kAccuracy}, strict{"c", 0.5, LimitKind::kAccuracy};
  EXPECT_EQ(LargestStep({swings, lax}), LargestStep({swings}));
  EXPECT_EQ(LargestStep({swings, lax, strict}), kStepSafety * 0.5);
}

TEST(StepLimits, OfViscosityAreThoseOfWavesOnLattices) {
  for (const SmoothingKernel kernel : kAllKernels) {
    double least = 1;
    for (const bool hexagonal : {false, true}) {
      least = std::min(least, LeastStep(hexagonal, [&](const Lattice& lattice, Vec2 k) {
                         return Spread(lattice, k, [&](double r) { return ViscousWeightAt(1, r); });
                       }));
    }
    Liquid liquid(kernel);
    liquid.sph.viscosity = 3;
    // d = 2 nu times the sum, d dt < 2, and half of that as velocities are extrapolated.
    const StepLimit limit = Named(liquid.Limits(), "viscosity");
    EXPECT_EQ(limit.of, LimitKind::kDecaying);
    EXPECT_NEAR(limit.seconds / (0.5 * least / 3), 1, 0.005) << "two digits";
  }
}

/// The longest step [1 half support over the speed of sound] that leapfrog keeps of all waves on the lattice, which
/// swing with omega and decay at the rate d: omega^2 dt^2/4 + d dt/2 = 1.
double StableStep(SmoothingKernel kernel, double diffusion, bool sharp, const Lattice& lattice) {
  const SharpWeights weights = sharp ? SharpWeightsOf(kernel) : SharpWeights{};
  double least = 1e9;
  lattice.ForWaves([&](Vec2 k) {
    // Gradients of the wave, its diffusion less what the mean of both particles' gradients takes away of it.
    const auto slope = [&](auto of) {
      return lattice.Sum([&](Vec2 x) { return Push(kernel, Length(x)) * of(x) * std::sin(Dot(k, x)); });
    };
    const Vec2 gradient{slope([](Vec2 x) { return x.x; }), slope([](Vec2 x) { return x.y; })};
    const double spread = Spread(lattice, k, [&](double r) { return Push(kernel, r); });
    const double d = 2 * diffusion * (spread - 0.5 * Dot(gradient, gradient));
    const auto sharpened = [&](Vec2 x) { return weights.flat - weights.fall * Dot(x, x) / 4; };
    const Vec2 push{slope([&](Vec2 x) { return x.x * sharpened(x); }),
                    slope([&](Vec2 x) { return x.y * sharpened(x); })};
    const double omega2 = std::max(0.0, Dot(gradient, push));
    least = std::min(least, 4 / (d + std::sqrt(d * d + 4 * omega2)));
  });
  return least;
}

TEST(StepLimits, OfSoundAndDiffusionTogetherAreNeverLongerThanLatticesKeep) {
  const double deltas[] = {0.02, 0.05, 0.1, 0.15, 0.17, 0.18, 0.19, 0.2, 0.25, 0.3, 0.5, 1.0};
  for (int k = 0; k < 2 * static_cast<int>(std::size(kAllKernels)); ++k) {
    const SmoothingKernel kernel = kAllKernels[k / 2];
    const bool sharp = k % 2 == 1;
    for (const double delta : deltas) {
      Liquid liquid(kernel);
      liquid.sph.delta.diffusion = delta;
      liquid.sph.delta.sharp_gradient = sharp;
      const auto limits = liquid.Limits();
      const double allowed =
          LargestStep({Named(limits, "speed of sound"), Named(limits, "density diffusion")}) / kStepSafety;
      double shortest = 1e9;
      for (const bool hexagonal : {false, true}) {
        for (const double spacing : kSpacings) {
          const double diffusion = delta * liquid.sph.smoothing_length;
          shortest = std::min(shortest, StableStep(kernel, diffusion, sharp, Lattice(spacing, hexagonal)));
        }
      }
      SCOPED_TRACE(std::string(PropertiesOf(kernel).name) + (sharp ? ", sharp, delta = " : ", delta = ") +
                   std::to_string(delta));
      EXPECT_LE(allowed, shortest);
      if (delta == 0.1 || delta == 0.2) {
        EXPECT_GT(allowed, shortest / 1.15);
      }
    }
  }
}

}  // namespace
}  // namespace sph
