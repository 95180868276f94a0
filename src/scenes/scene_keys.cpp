#include "scenes/scene_keys.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

const std::vector<std::string> kArrangements = {"random", "lattice", "jittered", "perturbed", "hexagonal", "relaxed"};
const std::vector<std::string> kIntegrations = {"leapfrog", "leapfrog-published", "symplectic-euler"};
const std::vector<std::string> kWallKinds = {"penalty", "mirror", "reflect", "particles"};
const std::vector<std::string> kSlips = {"free-slip", "no-slip"};
const std::vector<std::string> kWallScalings = {"derived", "published"};
const std::vector<std::string> kReferences = {"none", "static-star"};
const std::vector<std::string> kSteps = {"fixed", "adaptive"};
const std::vector<std::string> kPrecisions = {"float", "double"};
const std::vector<std::string> kKernels = {"wendland-c2", "wendland-c4", "quintic"};
const std::vector<std::string> kViscousForms = {"laplacian", "stress"};
const std::vector<std::string> kMasses = {"equal", "graded"};
const std::vector<std::string> kDelta = {"delta"};  // of solvers
const std::vector<std::string> kSwitch = {"off", "on"};
const std::vector<std::string> kDirections = {"x", "y", "both"};
const std::vector<std::string> kForms = {"right", "published"};
const std::vector<std::string> kFluidSides = {"left", "right", "below", "above"};

/// A number goes to the place that `where` names.
template <typename Where>
std::function<void(Scene&, const Value&)> Number(Accepted accepted, Where where) {
  return [accepted, where](Scene& scene, const Value& value) { where(scene) = value.AsNumber(accepted); };
}

/// One of `names` goes, as the enumerator of the same position, to the place that `where` names.
template <typename Where>
std::function<void(Scene&, const Value&)> Choice(const std::vector<std::string>& names, Where where) {
  return [&names, where](Scene& scene, const Value& value) {
    auto& place = where(scene);
    place = static_cast<std::remove_reference_t<decltype(place)>>(value.AsChoice(names));
  };
}

/// The scene's equation of state as one of that type; another type is replaced.
template <typename Equation>
Equation& As(Scene& scene) {
  EquationOfState& equation = scene.sph.equation_of_state;
  if (!std::holds_alternative<Equation>(equation)) equation = Equation{};
  return std::get<Equation>(equation);
}

StarForce& Star(Scene& scene) {
  if (!scene.star) scene.star.emplace();
  return *scene.star;
}

void WarnOfOldName(Scene& scene, const Value& value, const std::string& old, const std::string& now) {
  scene.warnings.push_back(fmt::format("{}: {} is the old name of {}", value.Place(), old, now));
}

bool ReadNoSlip(Scene& scene, const Value& value) {
  const std::vector<std::string> old_names = {"free", "none"};
  const auto old = std::ranges::find(old_names, value.AsText());
  if (old == old_names.end()) return value.AsChoice(kSlips) == 1;
  const auto k = static_cast<std::size_t>(old - old_names.begin());
  WarnOfOldName(scene, value, fmt::format("{} = '{}'", value.Key(), *old), fmt::format("'{}'", kSlips[k]));
  return k == 1;
}

std::vector<std::string> SolverNames() {
  std::vector<std::string> names;
  for (const Solver& solver : AllSolvers()) names.push_back(solver.name);
  return names;
}

std::vector<std::string> FlowNames() {
  std::vector<std::string> names;
  for (const InitialFlow& flow : AllInitialFlows()) names.push_back(flow.name);
  return names;
}

}  // namespace

std::span<const SceneKey> AllSceneKeys() {
  using S = Scene;
  using V = Value;
  constexpr When kStart = When::kAtStart;
  constexpr When kAny = When::kAnyTime;
  const Accepted any = Accepted::Any();
  const Accepted positive = Accepted::Positive();
  const Accepted not_negative = Accepted::NotNegative();
  static const std::vector<SceneKey> keys = {
      {"title", "one line for people", kStart, true, [](S& s, const V& v) { s.title = v.AsText(); }},
      {"about", "a few lines for people", kStart, false, [](S& s, const V& v) { s.about = v.AsText(); }},
      {"solver", "the method", kStart, false,
       [](S& s, const V& v) {
         const auto names = SolverNames();
         s.solver = names[v.AsChoice(names)];
       }},
      {"seed", "of the random start", kStart, false,
       [](S& s, const V& v) { s.base.seed = static_cast<std::uint64_t>(v.AsInteger(0, INT64_MAX)); }},
      {"until", "end of the run if not told [s]", kStart, false,
       Number(positive, [](S& s) -> double& { return s.until; })},
      {"view", "what is seen at first, [x0, y0, x1, y1] [m]", kStart, false,
       [](S& s, const V& v) { s.view = v.AsBox(); }},
      {"reference", "exact solution to compare with", kStart, false,
       Choice(kReferences, [](S& s) -> Reference& { return s.reference; })},

      {"fluid.particles", "number of particles; of a lattice without spacing about that", kStart, true,
       [](S& s, const V& v) { s.base.fluid.particles = static_cast<std::size_t>(v.AsInteger(1, kMostParticles)); }},
      {"fluid.mass", "mass of a particle [kg/m]", kStart, true,
       Number(positive, [](S& s) -> double& { return s.base.particle_mass; })},
      {"fluid.region.box", "[x0, y0, x1, y1] [m]", kStart, false,
       [](S& s, const V& v) {
         s.base.fluid.region.box = v.AsBox();
         s.base.fluid.region.radius = 0;
       }},
      {"fluid.region.disk.centre", "[x, y] [m]", kStart, false,
       [](S& s, const V& v) { s.base.fluid.region.centre = v.AsVec2(); }},
      {"fluid.region.disk.radius", "[m]", kStart, false,
       Number(positive, [](S& s) -> double& { return s.base.fluid.region.radius; })},
      {"fluid.arrange", "start", kStart, false,
       Choice(kArrangements, [](S& s) -> Arrangement& { return s.base.fluid.arrange; })},
      {"fluid.spacing", "of a lattice [m]; default: from region and particles", kStart, false,
       Number(positive, [](S& s) -> double& { return s.base.fluid.spacing; })},
      {"fluid.jitter", "largest shift of a jittered (to the right) or perturbed (any way) start [m]", kStart, false,
       Number(not_negative, [](S& s) -> double& { return s.base.fluid.jitter; })},
      {"fluid.flow", "exact solution to start with", kStart, false,
       [](S& s, const V& v) { s.sph.flow = &AllInitialFlows()[v.AsChoice(FlowNames())]; }},
      {"fluid.flow_speed", "U of that flow [m/s]", kStart, false,
       Number(positive, [](S& s) -> double& { return s.sph.flow_speed; })},
      {"fluid.masses", "equal, or in proportion to the density that goes with the flow", kStart, false,
       [](S& s, const V& v) { s.sph.graded_masses = v.AsChoice(kMasses) == 1; }},
      {"fluid.velocity", "[vx, vy] at the start [m/s]", kStart, false,
       [](S& s, const V& v) { s.base.fluid.velocity = v.AsVec2(); }},
      {"fluid.settle.time", "before the start, at rest and damped [s]", kStart, false,
       Number(positive, [](S& s) -> double& { return s.settling.time; })},
      {"fluid.settle.damping", "motion damping meanwhile [1/s]", kStart, false,
       Number(positive, [](S& s) -> double& { return s.settling.damping; })},
      {"fluid.limit", "most particles that dropped blocks may lead to", kAny, false,
       [](S& s, const V& v) { s.base.particle_limit = static_cast<std::size_t>(v.AsInteger(1, kMostParticles)); }},

      {"drop.particles", "of a block dropped with space", kAny, false,
       [](S& s, const V& v) { s.base.drop.particles = static_cast<std::size_t>(v.AsInteger(1, kMostParticles)); }},
      {"drop.box", "where the block appears, [x0, y0, x1, y1] [m]", kStart, false,
       [](S& s, const V& v) { s.base.drop.region.box = v.AsBox(); }},
      {"drop.spacing", "of its lattice [m]; default: that of the fluid", kAny, false,
       Number(positive, [](S& s) -> double& { return s.base.drop.spacing; })},
      {"drop.velocity", "[vx, vy] of the block [m/s]", kStart, false,
       [](S& s, const V& v) { s.base.drop.velocity = v.AsVec2(); }},

      {"method.smoothing_length", "h [m]; the support radius for solver mueller; default: from the spacing", kStart, false,
       Number(positive, [](S& s) -> double& { return s.sph.smoothing_length; })},
      {"method.step", "fixed, or the largest that the stability limits allow", kStart, false,
       [](S& s, const V& v) { s.base.adaptive_step = v.AsChoice(kSteps) == 1; }},
      {"method.precision", "of the passes over neighbours", kStart, false,
       Choice(kPrecisions, [](S& s) -> Precision& { return s.sph.precision; })},
      {"method.time_step", "dt [s]; the first one if the step is adaptive; default: from the speed of sound", kAny, false,
       Number(positive, [](S& s) -> double& { return s.base.time_step; })},
      {"method.retries", "how often a step that breaks down is undone and halved", kStart, false,
       [](S& s, const V& v) { s.retries = static_cast<int>(v.AsInteger(0, 30)); }},
      {"method.integration", "how velocities and positions advance", kStart, false,
       Choice(kIntegrations, [](S& s) -> Integration& { return s.base.integration; })},
      {"method.kernel", "solver delta; default: by the equation of state", kStart, false,
       Choice(kKernels, [](S& s) -> SmoothingKernel& { return s.sph.delta.kernel; }), kDelta},
      {"method.diffusion", "delta of density diffusion; solver delta, liquids", kAny, false,
       Number({0, 1}, [](S& s) -> double& { return s.sph.delta.diffusion; }), kDelta},
      {"method.artificial_viscosity", "alpha; solver delta, liquids", kAny, false,
       Number({0, 1}, [](S& s) -> double& { return s.sph.delta.artificial_viscosity; }), kDelta},
      {"method.sound_damping", "alpha of a bulk viscosity alpha h c rho0; solver delta, liquids", kAny, false,
       Number({0, 1}, [](S& s) -> double& { return s.sph.delta.sound_damping; }), kDelta},
      {"method.viscous_form", "of forces.viscosity; stress leaves a surface free; solver delta, liquids", kStart, false,
       Choice(kViscousForms, [](S& s) -> ViscousForm& { return s.sph.delta.viscous_form; }), kDelta},
      {"method.shifting", "of particles towards where they lack; solver delta, liquids", kStart, false,
       [](S& s, const V& v) { s.sph.delta.shifting = v.AsChoice(kSwitch) == 1; }, kDelta},
      {"method.sharp_gradient", "of pressure, to fourth order; solver delta, liquids without a surface", kStart, false,
       [](S& s, const V& v) { s.sph.delta.sharp_gradient = v.AsChoice(kSwitch) == 1; }, kDelta},
      {"method.tensile_control", "particles do not pull at each other; solver delta, liquids", kStart, false,
       [](S& s, const V& v) { s.sph.delta.tensile_control = v.AsChoice(kSwitch) == 1; }, kDelta},
      {"method.form", "solver mueller: right in the plane, or as first published", kStart, false,
       [](S& s, const V& v) { s.sph.mueller_published = v.AsChoice(kForms) == 1; }, {"mueller"}},

      {"periodic.box", "[x0, y0, x1, y1] of what repeats [m]", kStart, false,
       [](S& s, const V& v) { s.sph.periods.box = v.AsBox(); }},
      {"periodic.directions", "in which it does", kStart, false,
       [](S& s, const V& v) {
         const std::size_t choice = v.AsChoice(kDirections);
         s.sph.periods.in_x = choice != 1;
         s.sph.periods.in_y = choice != 0;
       }},

      {"equation_of_state.polytrope.k", "P = k rho^2 [Pa m^4/kg^2]", kAny, false,
       Number(positive, [](S& s) -> double& { return As<Polytrope>(s).k; })},
      {"equation_of_state.tait.k", "P = k ((rho/rho0)^exponent - 1) [Pa]", kAny, false,
       Number(positive, [](S& s) -> double& { return As<Tait>(s).k; })},
      {"equation_of_state.tait.rho0", "reference density [kg/m^3]", kAny, false,
       Number(positive, [](S& s) -> double& { return As<Tait>(s).rho0; })},
      {"equation_of_state.tait.exponent", "usually 7", kAny, false,
       Number({1, 20, true}, [](S& s) -> double& { return As<Tait>(s).exponent; })},
      {"equation_of_state.ideal_gas.k", "P = k (rho - rho0) [m^2/s^2]", kAny, false,
       Number(positive, [](S& s) -> double& { return As<IdealGas>(s).k; })},
      {"equation_of_state.ideal_gas.rho0", "reference density [kg/m^3]", kAny, false,
       Number(positive, [](S& s) -> double& { return As<IdealGas>(s).rho0; })},

      {"forces.gravity", "[gx, gy] [m/s^2]", kStart, false, [](S& s, const V& v) { s.base.gravity = v.AsVec2(); }},
      {"forces.central", "lambda of a = -lambda x [1/s^2]", kAny, false,
       Number(any, [](S& s) -> double& { return s.base.central_force; })},
      {"forces.star.mass", "lambda = 8 M k/(pi R^4): M [kg/m]", kStart, false,
       Number(positive, [](S& s) -> double& { return Star(s).mass; })},
      {"forces.star.radius", "lambda = 8 M k/(pi R^4): R [m]", kStart, false,
       Number(positive, [](S& s) -> double& { return Star(s).radius; })},
      {"forces.damping", "motion damping nu [1/s]", kAny, false,
       Number(not_negative, [](S& s) -> double& { return s.base.motion_damping; })},
      {"forces.viscosity", "mu [Pa s]; solvers mueller and delta", kAny, false,
       Number(not_negative, [](S& s) -> double& { return s.sph.viscosity; }), {"mueller", "delta"}},
      {"forces.surface_tension", "sigma [N]; solver delta, liquids", kAny, false,
       Number(not_negative, [](S& s) -> double& { return s.sph.delta.surface_tension; }), kDelta},

      {"walls.kind", "what happens to a particle inside a wall", kStart, false,
       Choice(kWallKinds, [](S& s) -> WallKind& { return s.base.wall.kind; })},
      {"walls.stiffness", "K of a = K depth [1/s^2]", kAny, false,
       Number(not_negative, [](S& s) -> double& { return s.base.wall.stiffness; })},
      {"walls.damping", "inside a wall [1/s]", kAny, false,
       Number(not_negative, [](S& s) -> double& { return s.base.wall.damping; })},
      {"walls.restitution", "speed after a reflection over speed before", kAny, false,
       Number({0, 1}, [](S& s) -> double& { return s.base.wall.restitution; })},
      {"walls.slip", "of the fluid along walls of kind mirror or particles that do not say", kStart, false,
       [](S& s, const V& v) { s.base.wall.no_slip = ReadNoSlip(s, v); }},
      {"walls.layer_viscosity", "kinematic, of a turbulent boundary layer along walls with slip [m^2/s]; 0: none", kStart, false,
       Number(not_negative, [](S& s) -> double& { return s.base.wall.layer_viscosity; })},
      {"walls.scaling", "how stiffness and damping follow --particles", kStart, false,
       Choice(kWallScalings, [](S& s) -> WallScaling& { return s.wall_scaling; })},
      {"arrows.wall", "the wall that Left and Right move", kStart, false,
       [](S& s, const V& v) { s.arrow_wall = v.AsText(); }},
      {"arrows.speed", "its speed while they are held [m/s]", kAny, false,
       Number(positive, [](S& s) -> double& { return s.arrow_speed; })},
  };
  return keys;
}

bool SceneKey::UsedBy(const std::string& solver) const {
  return solvers.empty() || std::ranges::find(solvers, solver) != solvers.end();
}

const SceneKey* FindSceneKey(std::string_view name) {
  const auto keys = AllSceneKeys();
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const SceneKey& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

namespace {

/// A number, or { mean, amplitude, frequency, phase }.
TangentialVelocity ReadTangentialVelocity(const Value& value) {
  if (value.Node().is_number()) return {value.AsNumber(Accepted::Any())};
  const toml::table* table = value.Node().as_table();
  if (table == nullptr) {
    throw UsageError("{}: {} takes a number [m/s] or {{ mean, amplitude, frequency, phase }}", value.Place(),
                     value.Key());
  }
  const std::vector<std::string> names = {"mean", "amplitude", "frequency", "phase"};
  for (const auto& [name, node] : *table) {
    if (std::ranges::find(names, name.str()) != names.end()) continue;
    throw UsageError("{}: unknown key '{}.{}'.{}", value.Inner(node, "").Place(), value.Key(), name.str(),
                     DidYouMean(name.str(), names));
  }
  if (table->contains("amplitude") != table->contains("frequency") ||
      (table->contains("phase") && !table->contains("amplitude"))) {
    throw UsageError("{}: {} takes amplitude [m/s] and frequency [Hz] together, and phase [rad] only with them",
                     value.Place(), value.Key());
  }
  const auto entry = [&](const std::string& name, const Accepted& accepted) {
    const toml::node* node = table->get(name);
    return node == nullptr ? 0 : value.Inner(*node, name).AsNumber(accepted);
  };
  return {entry("mean", Accepted::Any()), entry("amplitude", Accepted::Any()), entry("frequency", Accepted::Positive()),
          entry("phase", Accepted::Any())};
}

}  // namespace

std::span<const WallKey> AllWallKeys() {
  static const std::vector<WallKey> keys = {
      {"name", "a name for `move_wall` and `arrows.wall`", true,
       [](Scene&, Wall& w, const Value& v) { w.name = v.AsText(); }},
      {"at", "x of a vertical wall, y of a horizontal one [m]", true,
       [](Scene&, Wall& w, const Value& v) {
         const bool fixed = w.lowest == w.highest;
         w.at = v.AsNumber(fixed ? Accepted::Any() : Accepted{w.lowest, w.highest});
         if (fixed) w.lowest = w.highest = w.at;
       }},
      {"fluid", "the side on which the fluid is", true,
       [](Scene&, Wall& w, const Value& v) { w.fluid = static_cast<FluidSide>(v.AsChoice(kFluidSides)); }},
      {"range", "[least, greatest] of `at` when it moves [m]; after `at`", false,
       [](Scene&, Wall& w, const Value& v) {
         const Vec2 range = v.AsVec2();
         if (!(range.x <= w.at && w.at <= range.y)) {
           throw UsageError("{}: {} = [{}, {}] must contain at = {}", v.Place(), v.Key(), range.x, range.y, w.at);
         }
         w.lowest = range.x;
         w.highest = range.y;
       }},
      {"slip", "of the fluid along it; default: walls.slip", false,
       [](Scene& s, Wall& w, const Value& v) { w.no_slip = ReadNoSlip(s, v); }},
      {"tangential_velocity", "along itself, to the right or upwards, of a wall to which the fluid sticks [m/s]", false,
       [](Scene&, Wall& w, const Value& v) { w.tangential = ReadTangentialVelocity(v); }},
      {"slide", "old name of tangential_velocity", false,
       [](Scene& s, Wall& w, const Value& v) {
         WarnOfOldName(s, v, v.Key(), v.Key().substr(0, v.Key().rfind('.') + 1) + "tangential_velocity");
         w.tangential = {v.AsNumber(Accepted::Any())};
       },
       "tangential_velocity"},
  };
  return keys;
}

namespace {

/// One entry of `do`: { move_wall = "name", to = x } or { set = "key", to = value }.
std::variant<MoveWallAction, SetAction> ReadAction(const toml::node& node, const Value& list) {
  const auto* table = node.as_table();
  if (table != nullptr && table->size() == 2 && table->contains("to")) {
    const auto entry = [&](const char* name) { return list.Inner(*table->get(name), name); };
    const double to = entry("to").AsNumber(Accepted::Any());
    if (table->contains("move_wall")) return MoveWallAction{entry("move_wall").AsText(), to};
    if (table->contains("set")) return SetAction{entry("set").AsText(), to};
  }
  throw UsageError("{}: an entry of {} takes {}", list.Inner(node, "").Place(), list.Key(),
                   "{ move_wall = \"name\", to = number } or { set = \"key\", to = number }");
}

}  // namespace

std::span<const ControlKey> AllControlKeys() {
  static const std::vector<ControlKey> keys = {
      {"press", "the key", true, [](SceneControl& c, const Value& v) { c.press = v.AsText(); }},
      {"what", "one line for the help screen", false, [](SceneControl& c, const Value& v) { c.what = v.AsText(); }},
      {"do", "what happens, in this order", true,
       [](SceneControl& c, const Value& v) {
         const auto* entries = v.Node().as_array();
         if (entries == nullptr || entries->empty()) {
           throw UsageError("{}: {} takes a list of actions", v.Place(), v.Key());
         }
         for (const toml::node& entry : *entries) c.actions.push_back(ReadAction(entry, v));
       }},
  };
  return keys;
}

}  // namespace sph
