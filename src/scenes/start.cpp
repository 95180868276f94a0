#include "scenes/start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "sph/delta.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

/// The system's particles in the order in which they were placed.
std::vector<StartingParticle> InOrder(const ParticleSystemSPH& system) {
  const Particles& particles = system.State();
  std::vector<StartingParticle> start(particles.Size());
  for (std::size_t i = 0; i < particles.Size(); ++i) {
    start[particles.id[i]] = {particles.Position(i), particles.mass[i]};
  }
  return start;
}

/// Of as many particles as the fluid has in its region, whatever spacing it gives for a lattice.
double EvenSpacing(const Block& fluid) { return std::sqrt(fluid.region.Area() / static_cast<double>(fluid.particles)); }

/// The box around the fluid's region, with as many particles per area, at random places.
Block BoxAround(const Block& fluid) {
  Block block;
  block.region.box = fluid.region.Bounds();
  const double areas = fluid.region.radius > 0 ? 4 / std::numbers::pi : 1;  // of the box over the region's
  block.particles = static_cast<std::size_t>(std::ceil(areas * static_cast<double>(fluid.particles)));
  return block;
}

/// Mirrors at the sides of the box, but for those across which it repeats.
std::vector<Wall> Sides(const Box& box, const Periods& periods) {
  std::vector<Wall> walls;
  const auto add = [&](FluidSide side, double at) {
    Wall wall;
    wall.fluid = side;
    wall.at = wall.lowest = wall.highest = at;
    walls.push_back(wall);
  };
  if (!periods.in_x) add(FluidSide::kRight, box.x0), add(FluidSide::kLeft, box.x1);
  if (!periods.in_y) add(FluidSide::kAbove, box.y0), add(FluidSide::kBelow, box.y1);
  return walls;
}

std::vector<StartingParticle> OffTheSides(std::vector<StartingParticle> particles, const Box& box, double distance) {
  for (StartingParticle& particle : particles) {
    Vec2& at = particle.position;
    at = {std::clamp(at.x, box.x0 + distance, box.x1 - distance),
          std::clamp(at.y, box.y0 + distance, box.y1 - distance)};
  }
  return particles;
}

/// A gas comes to rest from random places, by a kernel with which particles do not pair: no crystal, but nearly as
/// even. Of a disk those that are nearest to its centre are taken.
std::vector<StartingParticle> RelaxedPacking(const Scene& scene, const Parameters& base) {
  constexpr double kSmoothingLength = 1.4, kSoundTimes = 60;  // in spacings; how often sound crosses one
  const double spacing = EvenSpacing(base.fluid);
  Parameters gas;
  gas.fluid = BoxAround(base.fluid);
  gas.seed = base.seed;
  gas.threads = base.threads;
  gas.particle_mass = spacing * spacing;
  if (!(gas.particle_mass > 0))
    throw TroubleError("the fluid of {} cannot be packed: its region is too small", scene.name);
  gas.time_step = 0.3 * spacing;
  gas.adaptive_step = true;
  gas.motion_damping = 0.3 / spacing;
  gas.walls = Sides(gas.fluid.region.box, scene.sph.periods);
  gas.wall.kind = WallKind::kMirror;
  ParametersSPH sph;
  sph.smoothing_length = kSmoothingLength * spacing;
  sph.equation_of_state = Polytrope{0.5};  // unit density and speed of sound
  sph.periods = scene.sph.periods;
  // A particle that was thrown at a side is its own image there, and would stay: hence a second start.
  std::vector<StartingParticle> start;
  for (int round = 0; round < 2; ++round) {
    Delta system(gas, sph);
    system.Reset();
    while (system.Time() < kSoundTimes * spacing && !system.Trouble()) system.Step();
    if (const auto& trouble = system.Trouble()) {
      throw TroubleError("the fluid of {} cannot be packed: {}", scene.name, trouble->Message());
    }
    start = InOrder(system);
    gas.start = OffTheSides(start, gas.fluid.region.box, 0.25 * spacing);
  }
  for (StartingParticle& particle : start) {
    particle.position = sph.periods.Wrap(particle.position);
    particle.mass = base.particle_mass;
  }
  if (base.fluid.region.radius > 0) {
    const auto distance = [&](const StartingParticle& particle) {
      return Length(particle.position - base.fluid.region.centre);
    };
    std::ranges::stable_sort(start, std::less{}, distance);
    start.resize(std::min(start.size(), base.fluid.particles));
  }
  return start;
}

/// Where the fluid comes to rest under its forces and a damping.
std::vector<StartingParticle> Settle(const Scene& scene, Parameters base) {
  base.fluid.velocity = {};
  base.motion_damping = scene.settling.damping;
  ParametersSPH sph = scene.sph;
  sph.flow_speed = 0;
  const auto system = FindSolver(scene.solver)->make(base, sph);
  system->Reset();
  while (system->Time() < scene.settling.time && !system->Trouble()) system->Step();
  if (const auto& trouble = system->Trouble()) {
    throw TroubleError("the fluid of {} cannot settle: {}", scene.name, trouble->Message());
  }
  return InOrder(*system);
}

}  // namespace

std::vector<StartingParticle> FindStart(const Scene& scene, const Parameters& base) {
  Parameters found = base;
  if (base.fluid.arrange == Arrangement::kRelaxed) found.start = RelaxedPacking(scene, base);
  if (scene.settling.time > 0) found.start = Settle(scene, found);
  return found.start;
}

}  // namespace sph
