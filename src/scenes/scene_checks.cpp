#include "scenes/scene_checks.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "scenes/placement_checks.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

std::vector<std::string> WallNames(std::span<const Wall> walls) {
  std::vector<std::string> names;
  for (const Wall& wall : walls) names.push_back(wall.name);
  return names;
}

bool Complete(const EquationOfState& equation) {
  const auto* polytrope = std::get_if<Polytrope>(&equation);
  const auto* tait = std::get_if<Tait>(&equation);
  const auto* ideal_gas = std::get_if<IdealGas>(&equation);
  return (polytrope != nullptr && polytrope->k > 0) || (tait != nullptr && tait->k > 0 && tait->rho0 > 0) ||
         (ideal_gas != nullptr && ideal_gas->k > 0 && ideal_gas->rho0 > 0);
}

void CheckEquation(const Scene& scene, const std::string& source) {
  if (!Complete(scene.sph.equation_of_state)) {
    throw UsageError(
        "{}: the fluid needs one of equation_of_state.polytrope = {{ k }}, equation_of_state.tait = {{ k, rho0 }}, "
        "equation_of_state.ideal_gas = {{ k, rho0 }}",
        source);
  }
  if (scene.star && (scene.star->mass <= 0 || scene.star->radius <= 0)) {
    throw UsageError("{}: forces.star takes both mass and radius", source);
  }
  if (scene.star && !std::holds_alternative<Polytrope>(scene.sph.equation_of_state)) {
    throw UsageError("{}: forces.star goes with equation_of_state.polytrope", source);
  }
}

void CheckRegion(const Scene& scene, const std::string& source) {
  const Region& region = scene.base.fluid.region;
  if (!(region.Area() > 0)) {
    throw UsageError(
        "{}: the fluid needs fluid.region.box = [x0, y0, x1, y1] or fluid.region.disk = {{ centre, radius }}", source);
  }
  const Box fluid = region.Bounds();
  const Box legal = LegalRegion(scene.base.walls);
  if (fluid.x0 < legal.x0 || fluid.x1 > legal.x1 || fluid.y0 < legal.y0 || fluid.y1 > legal.y1) {
    throw UsageError("{}: the fluid's region [{}, {}, {}, {}] reaches behind a wall; the walls leave [{}, {}, {}, {}]",
                     source, fluid.x0, fluid.y0, fluid.x1, fluid.y1, legal.x0, legal.y0, legal.x1, legal.y1);
  }
}

void CheckSettling(const Scene& scene, const std::string& source) {
  const Settling& settling = scene.settling;
  if ((settling.time > 0) != (settling.damping > 0)) {
    throw UsageError("{}: fluid.settle takes both time and damping", source);
  }
  constexpr double kMostSteps = 1e6;
  if (settling.time > kMostSteps * scene.base.time_step) {
    throw UsageError("{}: fluid.settle.time = {} s is more than a million steps of method.time_step = {} s", source,
                     settling.time, scene.base.time_step);
  }
}

/// What only some walls have is refused of others.
void CheckSlip(const Scene& scene, const std::string& source) {
  const WallParameters& all = scene.base.wall;
  const std::vector<Wall>& walls = scene.base.walls;
  const auto sticks = [&](const Wall& wall) { return Sticks(wall, all); };
  if (all.layer_viscosity > 0 && (!all.SeenByFluid() || (!walls.empty() && std::ranges::all_of(walls, sticks)))) {
    throw UsageError(
        "{}: walls.layer_viscosity takes walls.kind = 'mirror' or 'particles' and a wall with slip = 'free-slip'",
        source);
  }
  if (all.no_slip && !all.SeenByFluid()) {
    throw UsageError("{}: walls.slip = 'no-slip' takes walls.kind = 'mirror' or 'particles'", source);
  }
  for (const Wall& wall : walls) {
    if (wall.no_slip.value_or(false) && !all.SeenByFluid()) {
      throw UsageError("{}: wall '{}' has slip = 'no-slip', which takes walls.kind = 'mirror' or 'particles'", source,
                       wall.name);
    }
    if (!wall.tangential.Any() || sticks(wall)) continue;
    throw UsageError(
        "{}: wall '{}' has a tangential_velocity, which takes walls.kind = 'mirror' or 'particles' and slip = "
        "'no-slip'",
        source, wall.name);
  }
}

/// Where a lattice's sites are tried one by one, a slip in its spacing would take for ever.
void CheckSpacing(const Scene& scene, const std::string& source) {
  const Block& fluid = scene.base.fluid;
  const bool all_tried =
      fluid.arrange == Arrangement::kHexagonal || (fluid.arrange != Arrangement::kRandom && fluid.region.radius > 0);
  const double spacing = Spacing(fluid);
  const double most = 10'000 + 100 * static_cast<double>(fluid.particles);
  const Box bounds = fluid.region.Bounds();
  const double sites = bounds.Width() / spacing * (bounds.Height() / spacing);
  if (!all_tried || sites <= most) return;
  throw UsageError("{}: fluid.spacing = {} m makes {:.3g} sites for {} particles: it takes {:.3g} m or more", source,
                   spacing, sites, fluid.particles, spacing * std::sqrt(sites / most));
}

void CheckSeenWalls(const Scene& scene, const std::string& source) {
  if (!scene.base.wall.SeenByFluid()) return;
  if (scene.solver != "delta" || ReferenceDensity(scene.sph.equation_of_state) <= 0) {
    throw UsageError("{}: walls.kind = '{}' takes solver = 'delta' and a liquid (equation_of_state.tait or ideal_gas)",
                     source, scene.base.wall.kind == WallKind::kMirror ? "mirror" : "particles");
  }
}

/// Wall particles stand as close as the fluid's, in layers as far as the support reaches.
void CheckWallParticles(const Scene& scene, const std::string& source) {
  if (scene.base.wall.kind != WallKind::kParticles) return;
  constexpr double kMostLayers = 20;
  const double support = SupportOf(scene.sph.delta.kernel) * scene.sph.smoothing_length;
  const double spacing = Spacing(Fitted(scene.base.fluid));
  if (support <= kMostLayers * spacing) return;
  throw UsageError(
      "{}: walls.kind = 'particles' takes a support radius of at most {} spacings; here it is {:.4g}: "
      "method.smoothing_length <= {:.4g} m would do",
      source, kMostLayers, support / spacing, kMostLayers * spacing / SupportOf(scene.sph.delta.kernel));
}

void CheckPeriods(const Scene& scene, const std::string& source) {
  const Periods& periods = scene.sph.periods;
  if (!periods.Any() && periods.box == Box{}) return;
  if (!periods.Any() || periods.box == Box{}) {
    throw UsageError("{}: periodic takes both box = [x0, y0, x1, y1] and directions = \"x\", \"y\" or \"both\"",
                     source);
  }
  // Half a period is a third longer than the support at least, so that a step may be so long, see LongestMove; and
  // images are seen from wall particles that are as far beyond a seam.
  const double support = scene.solver == "delta" ? SupportOf(scene.sph.delta.kernel) : CubicSpline<2>::kSupport;
  const double reaches = scene.base.wall.kind == WallKind::kParticles ? 2 : 1;
  const double least = 2 * reaches * (4.0 / 3) * support * scene.sph.smoothing_length;
  if ((periods.in_x && periods.box.Width() <= least) || (periods.in_y && periods.box.Height() <= least)) {
    throw UsageError(
        "{}: periodic.box = [{}, {}, {}, {}] is too small: with method.smoothing_length = {} m it takes more than {} m",
        source, periods.box.x0, periods.box.y0, periods.box.x1, periods.box.y1, scene.sph.smoothing_length, least);
  }
}

void CheckControls(const Scene& scene, const std::string& source) {
  std::vector<Wall> walls = scene.base.walls;
  const auto check_wall = [&](const std::string& name, const std::string& user) {
    if (FindWall(walls, name) == nullptr) {
      throw UsageError("{}: {} names the wall '{}', which is not there.{}", source, user, name,
                       DidYouMean(name, WallNames(walls)));
    }
  };
  if (!scene.arrow_wall.empty()) {
    check_wall(scene.arrow_wall, "arrows.wall");
    if (scene.arrow_speed <= 0) throw UsageError("{}: arrows.wall needs arrows.speed [m/s], too", source);
  }
  for (const SceneControl& control : scene.controls) {
    const std::string user = fmt::format("key '{}'", control.press);
    for (const auto& action : control.actions) {
      if (const auto* move = std::get_if<MoveWallAction>(&action)) {
        check_wall(move->wall, user);
      } else {
        Scene trial = scene;
        SetWhileRunning(trial, std::get<SetAction>(action).key, std::get<SetAction>(action).to);
        CheckEquation(trial, fmt::format("{}: {}", source, user));
      }
    }
  }
}

}  // namespace

void CheckFluid(const Scene& scene, const std::string& source) {
  CheckRegion(scene, source);
  CheckEquation(scene, source);
}

void CheckWhole(const Scene& scene, const std::string& source) {
  CheckFluid(scene, source);
  CheckSettling(scene, source);
  CheckSpacing(scene, source);
  if (scene.reference == Reference::kStaticStar && !scene.star) {
    throw UsageError("{}: reference = 'static-star' needs forces.star", source);
  }
  CheckPeriods(scene, source);
  CheckPlacement(scene, source);
  CheckSeenWalls(scene, source);
  CheckWallParticles(scene, source);
  CheckSlip(scene, source);
  CheckControls(scene, source);
}

}  // namespace sph
