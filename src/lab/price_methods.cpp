#include "lab/price_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "lab/resolutions.hpp"
#include "scenes/build.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

/// Walls that push in place of mirrors: a particle that falls through the height of the fluid stops within half a
/// spacing, v^2/2 = K depth^2/2, and does not swing.
void PushInsteadOfMirrors(Scene& scene) {
  const Box fluid = scene.base.fluid.region.Bounds();
  const double depth = 0.5 * Spacing(scene.base.fluid);
  const double speed2 = 2 * Length(scene.base.gravity) * fluid.Height();
  scene.base.wall.stiffness = speed2 / (depth * depth);
  scene.base.wall.damping = 2 * std::sqrt(scene.base.wall.stiffness);
}

/// What the case asks for, without what it says of its own method.
SceneRequest ForAnother(const SceneRequest& request, const std::string& solver, bool mirrors) {
  SceneRequest other = request;
  std::erase_if(other.settings, [](const std::string& setting) { return setting.starts_with("method."); });
  if (mirrors) other.settings.push_back("walls.kind=penalty");
  other.solver = solver;
  return other;
}

std::string WhyNot(const Scene& own, const Solver& solver) {
  if (own.sph.viscosity > 0 && !solver.viscous) return "it has no viscosity";
  const auto sticks = [&](const Wall& wall) { return Sticks(wall, own.base.wall); };
  if (std::ranges::any_of(own.base.walls, sticks) && !solver.mirrors) return "fluid does not stick to its walls";
  if (own.base.wall.layer_viscosity > 0 && !solver.mirrors) return "its walls have no friction";
  return {};
}

/// Is what repeats too short for lists of neighbours? No kernel's support is longer than 2 h, and the lists reach at
/// most half of it beyond, unless the flow breaks down.
bool TooShort(const Scene& scene) {
  const Periods& periods = scene.sph.periods;
  const double least = 2 * 1.5 * 2 * scene.sph.smoothing_length;
  return (periods.in_x && periods.box.Width() < least) || (periods.in_y && periods.box.Height() < least);
}

/// The case's scene for a solver that is not the case's own.
Scene SceneFor(const Solver& solver, const Scene& own, const SceneRequest& request) {
  const bool mirrors = own.base.wall.SeenByFluid() && !solver.mirrors;
  SceneRequest as_filed;
  as_filed.scene = request.scene;
  const bool at_home = LoadScene(as_filed).solver == solver.name;
  Scene scene = LoadScene(ForAnother(request, solver.name, mirrors));
  if (mirrors) PushInsteadOfMirrors(scene);
  if (at_home) return scene;
  scene.sph.smoothing_length = solver.usual_h * Spacing(scene.base.fluid);
  if (TooShort(scene)) return scene;
  scene.base.time_step = std::min(scene.base.time_step, LargestStep(MakeSystem(scene)->StepLimits()));
  return scene;
}

}  // namespace

std::string_view NameOf(StepChoice step) {
  switch (step) {
    case StepChoice::kScene:
      return "fixed";
    case StepChoice::kHalf:
      return "half";
    case StepChoice::kAdaptive:
      return "adaptive";
  }
  return {};
}

Prepared Prepare(const VerificationCase& of, const Method& method, std::size_t particles, int threads) {
  SceneRequest request = of.request;
  request.particles = particles;
  request.threads = threads;
  try {
    const Solver& solver = *FindSolver(method.solver);
    Scene scene = LoadScene(request);
    if (solver.name != scene.solver) {
      if (const std::string why = WhyNot(scene, solver); !why.empty()) return {nullptr, why};
      scene = SceneFor(solver, scene, request);
    }
    if (TooShort(scene)) return {nullptr, "what repeats is too short for the kernel"};
    scene.sph.precision = method.precision;
    scene.base.adaptive_step = method.step == StepChoice::kAdaptive;
    if (method.step == StepChoice::kHalf) scene.base.time_step *= 0.5;
    return {MakeSystem(scene), {}};
  } catch (const UsageError& error) {
    return {nullptr, error.what()};
  }
}

std::vector<std::size_t> Resolutions(const VerificationCase& of) {
  const Block fluid = LoadScene(of.request).base.fluid;
  const auto own = static_cast<double>(fluid.particles);
  std::vector<std::size_t> numbers;
  for (int power = -6; power <= 2; ++power) {
    const double wanted = std::ldexp(own, power);
    const std::size_t rounded = static_cast<std::size_t>(std::llround(wanted));
    const std::size_t number =
        IsLatticeInBox(fluid) && power != 0 ? NearestFilling(fluid.region.box, wanted, std::numbers::sqrt2) : rounded;
    if (number > 0 && (numbers.empty() || number > numbers.back())) numbers.push_back(number);
  }
  return numbers;
}

}  // namespace sph
