// The flow that a sliding plate drags along, from start-up on, against its exact series.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/verification.hpp"

namespace sph {
namespace {

/// u = V z/L + sum over n of 2V/(n pi) (-1)^n sin(n pi z/L) exp(-n^2 pi^2 nu t/L^2), z from the plate at rest to that
/// with V [J. P. Morris, P. J. Fox and Y. Zhu, J. Comput. Phys. 136 (1997) 214].
double CouetteVelocity(double plate, double width, double nu, double z, double t) {
  constexpr int kTerms = 40;  // the first time leaves exp(-0.1 n^2) of term n
  double u = plate * z / width;
  for (int n = 1; n < kTerms; ++n) {
    const double wave = n * std::numbers::pi / width;
    u += (n % 2 == 0 ? 2 : -2) * plate / (n * std::numbers::pi) * std::sin(wave * z) * std::exp(-wave * wave * nu * t);
  }
  return u;
}

/// Root mean square error of velocity over the plate's, the greatest of five times while the profile becomes steady.
double WorstError(ParticleSystemSPH& system) {
  const Box box = system.parameters.fluid.region.box;
  const double width = box.Height();
  const double nu = system.parameters_sph.viscosity / ReferenceDensity(system.parameters_sph.equation_of_state);
  const double plate = FindWall(system.parameters.walls, "floor")->tangential.mean;
  // [s], in which the profile approaches the steady one.
  const double slowest = width * width / (std::numbers::pi * std::numbers::pi * nu);
  double worst = 0;
  for (const double share : {0.1, 0.3, 1.0, 3.0, 6.0}) {
    AdvanceTo(system, share * slowest);
    const Particles& p = system.State();
    double squares = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double error = p.vx[i] - CouetteVelocity(plate, width, nu, box.y1 - p.y[i], system.Time());
      squares += error * error;
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(p.Size())) / std::abs(plate));
  }
  return worst;
}

Verdict CouetteVerdict(ParticleSystemSPH& system, double bar, const Promise& promise) {
  const double worst = WorstError(system);
  return {.metric = "L2 of velocity over the plate's, worst of 5 times",
          .value = system.Trouble() ? kBroken : worst,
          .bar = bar,
          .reference = "exact series; elsewhere 0.0020 to 0.0069",
          .promise = promise};
}

}  // namespace

std::vector<Verdict> MeasureCouette(ParticleSystemSPH& system) {
  return {CouetteVerdict(system, 0.001, {2, "sums over whole supports of a lattice and its images"})};
}

std::vector<Verdict> MeasureDisorderedCouette(ParticleSystemSPH& system) {
  return {CouetteVerdict(system, 0.003, {1, "sums over particles in disorder"})};
}

}  // namespace sph
