// How the errors of the Taylor-Green vortices fall with the spacing.
#include "lab/verification.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

struct VortexErrors {
  double velocity = kBroken, pressure = kBroken;
};
VortexErrors VortexErrorsOf(ParticleSystemSPH& system) {
  const std::vector<Verdict> verdicts = MeasureTaylorGreen(system);
  return {verdicts[0].value, verdicts[1].value};
}

}  // namespace

/// The scene at 25 x 25 (the system given), 50 x 50 and 100 x 100: of second order, errors go down to a quarter each
/// time.
std::vector<Verdict> MeasureTaylorGreenOrder(ParticleSystemSPH& system) {
  const auto at = [&](std::size_t particles) {
    SceneRequest request;
    request.scene = "taylor-green";
    request.particles = particles;
    request.threads = system.parameters.threads;
    const auto finer = MakeSystem(LoadScene(request));
    return VortexErrorsOf(*finer);
  };
  const VortexErrors coarse = VortexErrorsOf(system);
  const bool broken = system.Trouble().has_value();
  const VortexErrors middle = broken ? VortexErrors{} : at(2500);
  const VortexErrors fine = broken ? VortexErrors{} : at(10000);
  const auto reduction = [&](double before, double after) { return broken ? kBroken : after / before; };
  return {{"L1 of speed, 50 x 50 over 25 x 25", reduction(coarse.velocity, middle.velocity), 0.25, "second order: 1/4"},
          {"L1 of speed, 100 x 100 over 50 x 50", reduction(middle.velocity, fine.velocity), 0.25, "second order: 1/4"},
          {"L1 of pressure, 100 x 100 over 25 x 25", reduction(coarse.pressure, fine.pressure), 0.25,
           "first order: 1/4; sums over particles in disorder promise no more"}};
}

}  // namespace sph
