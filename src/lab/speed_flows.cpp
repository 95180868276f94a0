#include "lab/speed_flows.hpp"

#include <cmath>

namespace sph {
namespace {

constexpr double kGravity = 9.81;   // [m/s^2]
constexpr double kDepth = 1;        // [m]
constexpr double kDensity = 1000;   // [kg/m^3]
constexpr double kBoxOfColumn = 4;  // [m]

}  // namespace

std::string_view NameOf(Flow flow) { return flow == Flow::kTank ? "tank" : "collapse"; }

double TimeScale() { return std::sqrt(kDepth / kGravity); }

Scene SpeedScene(Flow flow, std::size_t particles, Precision precision) {
  const bool tank = flow == Flow::kTank;
  const double width = tank ? 2 : 1;
  const double far = tank ? width : kBoxOfColumn;
  const double dx = std::sqrt(width * kDepth / static_cast<double>(particles));
  const double sound = 10 * std::sqrt(kGravity * kDepth);
  Scene scene;
  scene.name = NameOf(flow);
  scene.sph.smoothing_length = 1.3 * dx;
  scene.sph.equation_of_state = Tait{kDensity * sound * sound / 7, kDensity, 7};
  scene.sph.precision = precision;
  Parameters& base = scene.base;
  base.fluid.particles = particles;
  base.fluid.region.box = {0, 0, width, kDepth};
  base.fluid.arrange = Arrangement::kJittered;
  base.fluid.jitter = 0.1 * dx;
  base.particle_mass = kDensity * dx * dx;
  base.gravity = {0, -kGravity};
  base.motion_damping = tank ? 8 / TimeScale() : 0;
  base.time_step = 0.4 * scene.sph.smoothing_length / sound;
  base.walls = {{"left", FluidSide::kRight, 0, 0, 0, 0},
                {"right", FluidSide::kLeft, far, 0, far, far},
                {"floor", FluidSide::kAbove, 0, 0, 0, 0}};
  // The lowest layer carries the column g H/(K dx) = dx/100 deep; K dt^2 = 0.27 and damping dt = 0.52 are well below 4
  // and 2, where the walls would be unstable.
  base.wall = {WallKind::kPenalty, sound * sound / (dx * dx), sound / dx, 0};
  return scene;
}

}  // namespace sph
