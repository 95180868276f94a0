#include "scenes/scene_checks.hpp"

#include "base/error.hpp"
#include "base/nearest_name.hpp"
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

void CheckMirrors(const Scene& scene, const std::string& source) {
  if (scene.base.wall.kind != WallKind::kMirror) return;
  if (scene.solver != "delta" || ReferenceDensity(scene.sph.equation_of_state) <= 0) {
    throw UsageError(
        "{}: walls.kind = 'mirror' takes solver = 'delta' and a liquid (equation_of_state.tait or ideal_gas)", source);
  }
}

void CheckPeriods(const Scene& scene, const std::string& source) {
  const Periods& periods = scene.sph.periods;
  if (!periods.Any() && periods.box == Box{}) return;
  if (!periods.Any() || periods.box == Box{}) {
    throw UsageError("{}: periodic takes both box = [x0, y0, x1, y1] and directions = \"x\", \"y\" or \"both\"",
                     source);
  }
  // Lists reach at most a third beyond the support, which no kernel has greater than 3 h.
  const double least = 8 * scene.sph.smoothing_length;
  if ((periods.in_x && periods.box.Width() < least) || (periods.in_y && periods.box.Height() < least)) {
    throw UsageError(
        "{}: periodic.box = [{}, {}, {}, {}] is too small: with method.smoothing_length = {} m it takes {} m or more",
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

void CheckWhole(const Scene& scene, const std::string& source) {
  CheckRegion(scene, source);
  CheckEquation(scene, source);
  if (scene.reference == Reference::kStaticStar && !scene.star) {
    throw UsageError("{}: reference = 'static-star' needs forces.star", source);
  }
  CheckPeriods(scene, source);
  CheckMirrors(scene, source);
  CheckControls(scene, source);
}

}  // namespace sph
