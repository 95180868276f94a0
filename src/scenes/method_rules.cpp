#include "scenes/method_rules.hpp"

#include <algorithm>
#include <cmath>

#include "sph/solvers.hpp"

namespace sph {
namespace {

bool IsGas(const Scene& scene) { return ReferenceDensity(scene.sph.equation_of_state) <= 0; }

/// Of the particles as they start; where they stand on no lattice, its spacing says nothing.
double SpacingAtStart(const Block& fluid) {
  const bool lattice = fluid.arrange != Arrangement::kRandom && fluid.arrange != Arrangement::kRelaxed;
  return lattice ? Spacing(fluid) : std::sqrt(fluid.region.Area() / static_cast<double>(fluid.particles));
}

/// The smoothing length over the spacing. A gas whose density varies has fewer neighbours where it is thin.
double UsualRatio(const Scene& scene) {
  constexpr double kOfGas = 2.2;
  return scene.solver == "delta" && IsGas(scene) ? kOfGas : FindSolver(scene.solver)->usual_h;
}

/// Of the fluid as it is placed [m/s].
double SoundAtStart(const Scene& scene) {
  const double spacing = SpacingAtStart(scene.base.fluid);
  const double density =
      IsGas(scene) ? scene.base.particle_mass / (spacing * spacing) : ReferenceDensity(scene.sph.equation_of_state);
  return std::visit([&](const auto& equation) { return equation.SoundSpeed(density); }, scene.sph.equation_of_state);
}

}  // namespace

bool IsClosed(const Scene& scene) {
  const Region& region = scene.base.fluid.region;
  if (region.radius > 0 || IsGas(scene)) return false;
  Box room{};
  if (scene.base.wall.SeenByFluid())
    room = LegalRegion(scene.base.walls);
  else
    room = LegalRegion({});
  const Periods& periods = scene.sph.periods;
  if (periods.in_x) room.x0 = periods.box.x0, room.x1 = periods.box.x1;
  if (periods.in_y) room.y0 = periods.box.y0, room.y1 = periods.box.y1;
  const double gap =
      std::max({region.box.x0 - room.x0, room.x1 - region.box.x1, region.box.y0 - room.y0, room.y1 - region.box.y1});
  return gap < 0.5 * SpacingAtStart(scene.base.fluid);
}

void CompleteMethod(Scene& scene, const GivenKeys& given) {
  const auto open = [&](const char* key) { return !given.contains(key); };
  ParametersSPH& sph = scene.sph;
  DeltaParameters& delta = sph.delta;
  const bool closed = IsClosed(scene);
  if (open("method.kernel")) delta.kernel = IsGas(scene) ? SmoothingKernel::kWendlandC4 : SmoothingKernel::kWendlandC2;
  if (open("method.viscous_form")) delta.viscous_form = closed ? ViscousForm::kLaplacian : ViscousForm::kStress;
  if (open("method.sharp_gradient")) delta.sharp_gradient = closed;
  if (open("method.smoothing_length")) {
    sph.smoothing_length = UsualRatio(scene) * SpacingAtStart(scene.base.fluid);
  }
  if (open("method.step")) scene.base.adaptive_step = scene.solver == "delta" || open("method.time_step");
  if (open("method.time_step")) {
    constexpr double kFirst = 0.25;  // of h/c: an adaptive step grows to what the limits allow
    scene.base.time_step = kFirst * sph.smoothing_length / SoundAtStart(scene);
  }
}

}  // namespace sph
