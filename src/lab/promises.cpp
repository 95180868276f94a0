#include "lab/promises.hpp"

#include <algorithm>
#include <cmath>

#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

/// The method is one of weakly compressible flow: densities within a per cent go with speeds up to a tenth of sound's.
constexpr double kMostMach = 0.1;
constexpr double kMostMisfit = 0.05;  // of a particle's volume against the square that it stands for
/// Support radius in spacings: what is usual, that is about 20 to 60 neighbours.
constexpr double kLeastSupport = 2.4, kMostSupport = 4.5;

/// Extent of all that can be reached, where walls bound it, and of the start [m].
Box Room(const Scene& scene) {
  const Box legal = LegalRegion(scene.base.walls);
  Box room = scene.base.fluid.region.Bounds();
  const Box drop = CompleteParameters(scene).drop.region.Bounds();
  const auto widen = [](double& end, double to, bool upwards) {
    if (std::isfinite(to)) end = upwards ? std::max(end, to) : std::min(end, to);
  };
  for (const Box& box : {legal, drop}) {
    widen(room.x0, box.x0, false);
    widen(room.y0, box.y0, false);
    widen(room.x1, box.x1, true);
    widen(room.y1, box.y1, true);
  }
  return room;
}

/// What speeds the scene may come to [m/s], from what moves in it and how far things may fall.
double GreatestSpeed(const Scene& scene, const ParticleSystemSPH& system) {
  const Box room = Room(scene);
  const double across = std::hypot(room.Width(), room.Height());
  const double fall = std::sqrt(2 * Length(scene.base.gravity) * across);
  const double swing = std::sqrt(std::abs(CompleteParameters(scene).central_force)) * across;
  return Diagnose(system).max_speed + Length(scene.base.drop.velocity) + fall + swing + FastestSlide(scene) +
         scene.arrow_speed;
}

/// A liquid with the numbers of the weakly compressible method.
bool IsSlowLiquid(const Scene& scene, const ParticleSystemSPH& system) {
  const double rho0 = ReferenceDensity(scene.sph.equation_of_state);
  if (scene.solver != "delta" || rho0 <= 0) return false;
  if (system.FlowAt(scene.base.fluid.region.Bounds().Centre()).density > 0) return false;  // a gas's, which swells
  const double c = std::visit([&](const auto& e) { return e.SoundSpeed(rho0); }, scene.sph.equation_of_state);
  const double dx = Spacing(scene.base.fluid);
  const double support = system.Support();
  const double tension = std::sqrt(scene.sph.delta.surface_tension / (rho0 * dx));
  const double misfit = scene.base.particle_mass / (rho0 * dx * dx) - 1;
  return GreatestSpeed(scene, system) + tension <= kMostMach * c && std::abs(misfit) <= kMostMisfit &&
         support >= kLeastSupport * dx && support <= kMostSupport * dx &&
         (scene.base.walls.empty() || scene.base.wall.SeenByFluid());
}

/// Terms of damping that are taken from the step before are stable, and take energy, up to a rate of one a step.
bool DampingIsKept(const Scene& scene) {
  const Parameters& base = scene.base;
  if (base.integration == Integration::kLeapFrog) return true;
  const double walls = base.wall.kind == WallKind::kPenalty ? base.wall.damping : 0;
  return (base.motion_damping + walls) * base.time_step < 1;
}

bool PromisesEnergy(const Scene& scene, bool sound_liquid) {
  if (scene.solver == "mueller" || !DampingIsKept(scene)) return false;
  // Particles are put back on walls that reflect them, against the pressure of the others: that puts energy in.
  if (!scene.base.walls.empty() && scene.base.wall.kind == WallKind::kReflect) return false;
  const bool periodic = scene.sph.periods.Any();
  if (periodic && CompleteParameters(scene).central_force != 0) return false;  // which has no potential there
  const bool everywhere = scene.sph.periods.in_x && scene.sph.periods.in_y;
  const bool liquid = scene.solver == "delta" && ReferenceDensity(scene.sph.equation_of_state) > 0;
  return !liquid || (sound_liquid && (!scene.sph.delta.sharp_gradient || everywhere));
}

/// Nothing moves at the start, and the walls hold what gravity and pressure push at them: behind every side of the
/// fluid there is a wall or its own next period, but for a surface straight above.
bool StartsInBalance(const Scene& scene, const ParticleSystemSPH& system) {
  const Parameters& base = scene.base;
  const Vec2 g = base.gravity;
  const bool still = Diagnose(system).max_speed == 0 && FastestSlide(scene) == 0 && base.central_force == 0 &&
                     !scene.star && scene.sph.delta.surface_tension == 0;
  const bool hydrostatic = scene.sph.flow != nullptr && scene.sph.flow->name == "hydrostatic";
  if (!still || base.fluid.region.radius > 0 || !(hydrostatic || g == Vec2{})) return false;
  const Box fluid = base.fluid.region.box, legal = LegalRegion(base.walls);
  const Periods& periods = scene.sph.periods;
  const double near = 1e-9 * std::max(fluid.Width(), fluid.Height());
  const auto meets = [&](double a, double b) { return std::abs(a - b) <= near; };
  const bool left = meets(fluid.x0, legal.x0), right = meets(fluid.x1, legal.x1);
  const bool below = meets(fluid.y0, legal.y0), above = meets(fluid.y1, legal.y1);
  const bool x_repeats = periods.in_x && meets(fluid.Width(), periods.box.Width());
  const bool y_repeats = periods.in_y && meets(fluid.Height(), periods.box.Height());
  const bool sides = (left && right) || (x_repeats && g.x == 0);
  const bool ends = (below && above) || (y_repeats && g.y == 0) || (below && g.x == 0 && g.y < 0);
  return sides && ends;
}

}  // namespace

double FastestSlide(const Scene& scene) {
  double fastest = 0;
  for (const Wall& wall : scene.base.walls) {
    fastest = std::max(fastest, std::abs(wall.tangential.mean) + std::abs(wall.tangential.amplitude));
  }
  return fastest;
}

Promises PromisesOf(const Scene& scene, const ParticleSystemSPH& system) {
  const Block& fluid = scene.base.fluid;
  const bool even = fluid.arrange != Arrangement::kRandom && fluid.jitter <= 0.5 * Spacing(fluid);
  const bool slow = IsSlowLiquid(scene, system);
  const bool balanced = slow && StartsInBalance(scene, system);
  const bool calm = slow && (balanced || even);
  return {.energy = PromisesEnergy(scene, slow && even), .volume = calm, .rest = balanced && even, .calm = calm};
}

}  // namespace sph
