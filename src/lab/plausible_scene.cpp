#include "lab/plausible_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lab/known_keys.hpp"
#include "scenes/scene_keys.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

/// A block of fluid: a lattice that fits, its density, and what speeds it shall bear.
struct Fluid {
  std::size_t columns = 0, rows = 0;
  double spacing = 0;  // [m]
  double density = 0;  // [kg/m^3]
  double sound = 0;    // [m/s]

  double Width() const { return spacing * static_cast<double>(columns); }
  double Height() const { return spacing * static_cast<double>(rows); }
  std::size_t Particles() const { return columns * rows; }
};

Fluid SomeFluid(Dice& dice) {
  constexpr std::size_t kMost = 220;
  Fluid fluid;
  fluid.columns = 5 + dice.Below(16);
  fluid.rows = 5 + dice.Below(std::min<std::size_t>(16, kMost / fluid.columns - 4));
  fluid.spacing = dice.Scale(1e-3, 0.3);
  fluid.density = dice.Scale(0.5, 3000);
  return fluid;
}

std::string Set(const std::string& key, const std::string& value) { return fmt::format("{} = {}\n", key, value); }
std::string Set(const std::string& key, double value) { return fmt::format("{} = {:.16e}\n", key, value); }
std::string SetName(const std::string& key, const std::string& name) { return fmt::format("{} = \"{}\"\n", key, name); }
std::string SetVec2(const std::string& key, Vec2 v) { return fmt::format("{} = [{:.16e}, {:.16e}]\n", key, v.x, v.y); }

std::string SetAny(const std::string& key, Dice& dice) { return SetName(key, dice.OneOf(ChoicesOf(key))); }

/// Sides of a box, in the order of its walls.
enum Side { kLeft, kRight, kFloor, kCeiling };
constexpr std::array<const char*, 4> kSideNames = {"left", "right", "floor", "ceiling"};
constexpr std::array<const char*, 4> kFluidSides = {"right", "left", "above", "below"};

struct PlannedWall {
  Side side = kFloor;
  double at = 0;
  std::string more = {};  ///< further lines
};

std::string Walls(const std::vector<PlannedWall>& walls) {
  std::string text;
  for (const PlannedWall& wall : walls) {
    text += fmt::format("[[wall]]\nname = \"{}\"\nat = {:.16e}\nfluid = \"{}\"\n{}", kSideNames[wall.side], wall.at,
                        kFluidSides[wall.side], wall.more);
  }
  return text;
}

std::string Start(Dice& dice, const Fluid& fluid) {
  std::string text = SetAny("fluid.arrange", dice);
  if (dice.Chance(0.7)) text += Set("fluid.jitter", dice.Uniform(0.02, 0.3) * fluid.spacing);
  return text;
}

std::string Box0(const Fluid& fluid) {
  return fmt::format("[0.0, 0.0, {:.16e}, {:.16e}]", fluid.Width(), fluid.Height());
}

std::string Liquid(Dice& dice, const Fluid& fluid) {
  const double c2 = fluid.sound * fluid.sound;
  std::string text = Set("fluid.particles", std::to_string(fluid.Particles())) +
                     Set("fluid.mass", fluid.density * fluid.spacing * fluid.spacing);
  if (dice.Chance(0.5)) {
    return text + fmt::format("equation_of_state.ideal_gas = {{ k = {:.16e}, rho0 = {:.16e} }}\n", c2, fluid.density);
  }
  return text + fmt::format("equation_of_state.tait = {{ k = {:.16e}, rho0 = {:.16e} }}\n", fluid.density * c2 / 7,
                            fluid.density);
}

/// The step: adaptive, or well within the limits of sound and of a kinematic viscosity.
std::string Step(Dice& dice, double h, double sound, double viscosity) {
  const double limit = std::min(h / sound, 0.1 * h * h / std::max(viscosity, 1e-30));
  std::string text = Set("method.time_step", dice.Uniform(0.1, 0.5) * limit);
  if (dice.Chance(0.7)) text += SetName("method.step", "adaptive");
  if (dice.Chance(0.3)) text += SetAny("method.precision", dice);
  if (dice.Chance(0.1)) text += SetAny("method.integration", dice);
  return text;
}

/// Solver delta as it comes, or with some of its keys set to what people try.
std::string DeltaMethod(Dice& dice, const Fluid& fluid, double viscosity) {
  std::string text = SetName("solver", "delta");
  double h = 2 * fluid.spacing;
  if (FindSceneKey("method.smoothing_length")->required || dice.Chance(0.3)) {
    const std::string kernel = dice.OneOf(ChoicesOf("method.kernel"));
    h = fluid.spacing * (kernel == "quintic" ? dice.Uniform(0.92, 1.35) : dice.Uniform(1.3, 2.1));
    text += SetName("method.kernel", kernel) + Set("method.smoothing_length", h);
  }
  text += Step(dice, h, fluid.sound, viscosity);
  if (dice.Chance(0.3)) text += Set("method.diffusion", dice.Uniform(0.02, 0.3));
  if (dice.Chance(0.2)) text += Set("method.artificial_viscosity", dice.Scale(0.003, 0.1));
  if (dice.Chance(0.2)) text += Set("method.sound_damping", dice.Uniform(0.05, 0.4));
  if (dice.Chance(0.15)) text += SetAny("method.shifting", dice);
  if (dice.Chance(0.15)) text += SetAny("method.tensile_control", dice);
  if (dice.Chance(0.15)) text += SetAny("method.viscous_form", dice);
  return text;
}

/// Kinds of walls that a liquid of delta sees: no particle gets into them. The first of them reflects the liquid; the
/// other, particles behind the wall, takes twice as long a period.
std::vector<std::string> SeenKinds() {
  std::vector<std::string> kinds = ChoicesOf("walls.kind");
  std::erase_if(kinds, [](const std::string& kind) { return kind == "penalty" || kind == "reflect"; });
  return kinds;
}

/// How a liquid of delta meets its walls: slip or not, of all walls or of one, and walls that slide.
std::string SeenWalls(Dice& dice, const std::string& kind, std::vector<PlannedWall> walls, double slide_speed,
                      bool sticks) {
  const std::vector<std::string>& slips = ChoicesOf("walls.slip");  // the free one first
  for (PlannedWall& wall : walls) {
    bool stuck = sticks;
    if (dice.Chance(0.3)) {
      stuck = !stuck;
      wall.more += SetName("slip", slips[stuck ? 1 : 0]);
    }
    if (!stuck || slide_speed == 0 || dice.Chance(0.4)) continue;
    const double speed = (dice.Chance(0.5) ? 1 : -1) * slide_speed;
    const bool swings = dice.Chance(0.3);
    wall.more +=
        swings
            ? fmt::format(
                  "tangential_velocity = {{ mean = 0.0, amplitude = {:.16e}, frequency = {:.16e}, phase = {:.16e} }}\n",
                  speed, slide_speed * dice.Scale(0.3, 30), dice.Uniform(0, 6))
            : Set("tangential_velocity", speed);
  }
  return SetName("walls.kind", kind) + SetName("walls.slip", slips[sticks ? 1 : 0]) + Walls(walls);
}

/// Downwards, or tilted by up to a right angle.
Vec2 Gravity(Dice& dice, double g) {
  if (dice.Chance(0.6)) return {0, -g};
  const double angle = dice.Uniform(-0.5, 0.5) * std::numbers::pi;
  return {g * std::sin(angle), -g * std::cos(angle)};
}

/// A tank of water: full or with a surface, as wide as the water or wider, at rest, set in motion, or dragged along.
std::string Tank(Dice& dice) {
  Fluid fluid = SomeFluid(dice);
  const double g = dice.Chance(0.9) ? dice.Scale(0.3, 30) : 0.0;
  const bool closed = dice.Chance(0.4), full = closed && dice.Chance(0.7);
  const double wide = full || dice.Chance(0.5) ? 1 : dice.Uniform(1.2, 3);
  const double high = full ? 1 : dice.Uniform(1.3, 2.5);
  const bool at_rest = wide == 1 && dice.Chance(0.6);
  const double width = wide * fluid.Width(), height = high * fluid.Height();
  const double fall = std::sqrt(2 * std::max(g, 0.3) * std::hypot(width, std::max(height, 2 * fluid.Height())));
  const bool sticks = dice.Chance(0.5);
  const double slide = sticks && !at_rest ? dice.Uniform(0.1, 1) * fall : 0;
  const double shove = at_rest ? 0 : dice.Uniform(0, 0.5) * fall;
  const bool dam = wide > 1 && dice.Chance(0.4);
  const double arrows = dam ? 0.2 * fall : 0;
  fluid.sound = dice.Uniform(10.5, 14) * (fall + slide + shove + arrows);
  const double viscosity = dice.Chance(0.7) ? fall * fluid.Height() / dice.Scale(3, 3000) : 0;

  std::string text = "title = \"random: a tank\"\n" + Set("fluid.region.box", Box0(fluid)) + Start(dice, fluid) +
                     Liquid(dice, fluid) + DeltaMethod(dice, fluid, viscosity);
  const Vec2 gravity = full ? Gravity(dice, g) : at_rest || dice.Chance(0.7) ? Vec2{0, -g} : Gravity(dice, g);
  text += SetVec2("forces.gravity", gravity) + Set("forces.viscosity", fluid.density * viscosity);
  const bool held = full || gravity.x == 0;  // what a surface leaves no wall for has no pressure to start with
  if (at_rest || dice.Chance(0.5)) text += SetName("fluid.flow", g == 0 || !held ? "rest" : "hydrostatic");
  if (shove > 0)
    text += SetVec2("fluid.velocity", {dice.Uniform(-1, 1) * shove / 1.5, dice.Uniform(-1, 1) * shove / 1.5});
  std::vector<PlannedWall> walls = {{kLeft, 0}, {kRight, width}, {kFloor, 0}};
  if (dam) {
    walls[1].at = fluid.Width();
    walls[1].more = fmt::format("range = [{:.16e}, {:.16e}]\n", 0.8 * fluid.Width(), width);
    text += SetName("arrows.wall", "right") + Set("arrows.speed", arrows);
  }
  if (closed) walls.push_back({kCeiling, height});
  text += SeenWalls(dice, dice.OneOf(SeenKinds()), walls, slide, sticks);
  if (dam) text += fmt::format("[[key]]\npress = \"d\"\ndo = [ {{ move_wall = \"right\", to = {:.16e} }} ]\n", width);
  return text;
}

/// A channel that repeats, driven by a force or by its walls.
std::string Channel(Dice& dice) {
  Fluid fluid = SomeFluid(dice);
  const bool wide = dice.Chance(0.5);
  fluid.columns = wide ? 24 : 14;  // a period is longer than what its particles see
  fluid.rows = std::min<std::size_t>(fluid.rows, wide ? 9 : 15);
  const double speed = dice.Scale(0.01, 10), height = fluid.Height();
  const double viscosity = speed * height / dice.Scale(0.3, 1000);
  const bool sticks = dice.Chance(0.8);
  const double slide = sticks && dice.Chance(0.5) ? speed : 0;
  const Vec2 force = slide == 0 || dice.Chance(0.3)
                         ? Vec2{std::min(8 * viscosity * speed / (height * height), speed * speed / height), 0}
                         : Vec2{};
  const double across = std::hypot(fluid.Width(), 2 * height);
  fluid.sound = dice.Uniform(10.5, 14) * (slide + speed + std::sqrt(2 * force.x * across));
  std::string text = "title = \"random: a channel\"\n" + Set("fluid.region.box", Box0(fluid)) + Start(dice, fluid) +
                     Liquid(dice, fluid) + DeltaMethod(dice, fluid, viscosity) + Set("periodic.box", Box0(fluid)) +
                     SetName("periodic.directions", "x") + SetVec2("forces.gravity", force) +
                     Set("forces.viscosity", fluid.density * viscosity);
  if (dice.Chance(0.5)) text += SetVec2("fluid.velocity", {dice.Uniform(-1, 1) * speed, 0});
  return text +
         SeenWalls(dice, SeenKinds()[wide ? dice.Below(2) : 0], {{kFloor, 0}, {kCeiling, height}}, slide, sticks);
}

/// A square that repeats, with vortices in it or carried along.
std::string Vortices(Dice& dice) {
  Fluid fluid = SomeFluid(dice);
  fluid.columns = fluid.rows = 14 + dice.Below(2);
  const double speed = dice.Scale(0.01, 10), viscosity = speed * fluid.Width() / dice.Scale(3, 3000);
  const double across = std::hypot(fluid.Width(), 3 * fluid.Width());
  const double g = dice.Chance(0.2) ? 0.1 * speed * speed / across : 0;
  fluid.sound = dice.Uniform(10.5, 14) * (2 * speed + std::sqrt(2 * g * across));
  std::string text = "title = \"random: vortices\"\n" + Set("fluid.region.box", Box0(fluid)) + Start(dice, fluid) +
                     Liquid(dice, fluid) + DeltaMethod(dice, fluid, viscosity) + Set("periodic.box", Box0(fluid)) +
                     SetName("periodic.directions", "both") + Set("forces.viscosity", fluid.density * viscosity) +
                     SetVec2("forces.gravity", Gravity(dice, g));
  if (dice.Chance(0.3)) text += SetAny("method.sharp_gradient", dice);
  if (dice.Chance(0.3)) text += SetVec2("fluid.velocity", {dice.Uniform(-1, 1) * speed, 0});
  if (dice.Chance(0.8)) text += SetName("fluid.flow", "taylor-green") + Set("fluid.flow_speed", speed);
  return text;
}

/// A drop, or a square, that nothing holds but a central force or its surface.
std::string Drop(Dice& dice) {
  Fluid fluid = SomeFluid(dice);
  const bool square = dice.Chance(0.3);
  fluid.columns = fluid.rows = 8 + dice.Below(7);
  const double radius = 0.5 * fluid.Width(), speed = dice.Scale(0.01, 10);
  const double across = 3 * std::hypot(fluid.Width(), fluid.Width());
  const double central = dice.Chance(0.4) ? std::pow(dice.Uniform(0.1, 1) * speed / across, 2) : 0;
  const double tension = dice.Chance(0.4) ? dice.Uniform(0, 0.5) * speed * speed * fluid.density * fluid.spacing : 0;
  fluid.sound = dice.Uniform(11, 14) * 3.5 * speed;
  std::string text = "title = \"random: a drop\"\n" + DeltaMethod(dice, fluid, 0) + Start(dice, fluid);
  if (square) {
    text += Liquid(dice, fluid) + Set("fluid.region.box", Box0(fluid)) + SetName("fluid.flow", "rotating-square");
  } else {
    // As many as a disk of this radius holds of the lattice.
    const double in_disk = std::numbers::pi / 4 * static_cast<double>(fluid.Particles());
    Fluid disk = fluid;
    disk.columns = static_cast<std::size_t>(in_disk);
    disk.rows = 1;
    text += Liquid(dice, disk) + SetVec2("fluid.region.disk.centre", {0, 0}) + Set("fluid.region.disk.radius", radius);
    if (dice.Chance(0.8)) text += SetName("fluid.flow", "stretching");
  }
  text += Set("fluid.flow_speed", speed) + Set("forces.central", central) + Set("forces.surface_tension", tension);
  if (dice.Chance(0.3)) text += SetVec2("fluid.velocity", {dice.Uniform(-0.5, 0.5) * speed, 0});
  return text;
}

/// A star of gas, P = k rho^2, between walls that it may touch.
std::string Star(Dice& dice) {
  const double radius = dice.Scale(0.01, 10), mass = dice.Scale(0.01, 100), k = dice.Scale(0.01, 100);
  const std::size_t particles = 30 + dice.Below(200);
  const double spacing = radius * std::sqrt(std::numbers::pi / static_cast<double>(particles));
  const double sound = std::sqrt(4 * k * mass / (std::numbers::pi * radius * radius));  // in the static star's centre
  const bool delta = dice.Chance(0.5);
  const double h = spacing * (delta ? dice.Uniform(1.4, 2.2) : dice.Uniform(0.9, 1.6));
  std::string text = "title = \"random: a star\"\n" + SetName("solver", delta ? "delta" : "paper") +
                     Set("fluid.particles", std::to_string(particles)) +
                     Set("fluid.mass", mass / static_cast<double>(particles)) + SetAny("fluid.arrange", dice) +
                     SetVec2("fluid.region.disk.centre", {0, 0}) + Set("fluid.region.disk.radius", radius) +
                     Set("equation_of_state.polytrope.k", k) + Set("method.smoothing_length", h) +
                     Step(dice, 0.5 * h, sound, 0) +
                     fmt::format("forces.star = {{ mass = {:.16e}, radius = {:.16e} }}\n", mass, radius);
  static const std::vector<std::string> flows = {"star", "breathing-star", "elliptic-star"};
  if (dice.Chance(0.6)) {
    text += SetName("fluid.flow", dice.OneOf(flows)) + Set("fluid.flow_speed", dice.Uniform(0.05, 0.5) * sound);
    if (dice.Chance(0.5)) text += SetAny("fluid.masses", dice);
  }
  if (dice.Chance(0.5)) text += Set("forces.damping", dice.Uniform(0, 1) * sound / radius);
  if (dice.Chance(0.5)) return text;
  const double wall = radius * dice.Uniform(1.05, 2);
  const double rate = sound / spacing;
  text += SetName("walls.kind", dice.Chance(0.7) ? "penalty" : "reflect") + Set("walls.stiffness", rate * rate) +
          Set("walls.damping", dice.Uniform(0, 1) * rate) + Set("walls.restitution", dice.Uniform(0, 1));
  return text + Walls({{kLeft, -wall}, {kRight, wall}, {kFloor, -wall}, {kCeiling, wall}});
}

/// A tank of the two documents' solvers: a compressible liquid between walls that push or reflect.
std::string DocumentsTank(Dice& dice) {
  Fluid fluid = SomeFluid(dice);
  const bool mueller = dice.Chance(0.5);
  const double g = dice.Scale(0.3, 30), width = dice.Uniform(1, 3) * fluid.Width();
  fluid.sound = dice.Uniform(3, 10) * std::sqrt(g * fluid.Height());
  const double h = fluid.spacing * (mueller ? dice.Uniform(1.6, 2.4) : dice.Uniform(0.9, 1.5));
  const double rate = fluid.sound / fluid.spacing;
  std::string text = "title = \"random: a tank of the documents\"\n" +
                     SetName("solver", mueller ? "mueller" : "paper") + Set("fluid.region.box", Box0(fluid)) +
                     Start(dice, fluid) + Liquid(dice, fluid) + Set("method.smoothing_length", h) +
                     Step(dice, 0.5 * h, fluid.sound, 0) + SetVec2("forces.gravity", Gravity(dice, g)) +
                     SetName("walls.kind", dice.Chance(0.6) ? "penalty" : "reflect") +
                     Set("walls.stiffness", rate * rate) + Set("walls.damping", dice.Uniform(0, 1) * rate) +
                     Set("walls.restitution", dice.Uniform(0, 1));
  if (mueller)
    text += SetAny("method.form", dice) +
            Set("forces.viscosity", fluid.density * fluid.sound * fluid.spacing * dice.Uniform(0.05, 0.5));
  if (dice.Chance(0.5)) text += Set("forces.damping", dice.Uniform(0, 2) * std::sqrt(g / fluid.Height()));
  const double top = 2 * fluid.Height();
  text += SetName("arrows.wall", "right") + Set("arrows.speed", 0.1 * fluid.sound);
  return text + Walls({{kLeft, 0},
                       {kRight, width, fmt::format("range = [{:.16e}, {:.16e}]\n", 0.7 * fluid.Width(), 2 * width)},
                       {kFloor, 0},
                       {kCeiling, top}});
}

}  // namespace

std::string PlausibleScene(Dice& dice) {
  const double choice = dice.Uniform(0, 1);
  if (choice < 0.4) return Tank(dice);
  if (choice < 0.55) return Channel(dice);
  if (choice < 0.65) return Vortices(dice);
  if (choice < 0.75) return Drop(dice);
  if (choice < 0.87) return Star(dice);
  return DocumentsTank(dice);
}

}  // namespace sph
