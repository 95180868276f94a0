// What nobody would do to a fluid, done to scenes of every solver: each must end well, or unstable with its cause
// named, with every particle still there and every number a number.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "lab/stress.hpp"
#include "particles/guard.hpp"
#include "scenes/build.hpp"
#include "scenes/changes.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_keys.hpp"

namespace sph {
namespace {

/// A scene that runs, and what has become of it.
class Victim {
 public:
  explicit Victim(const Scene& scene) : scene_(scene) { Start(); }

  /// From the beginning, after a change of the scene.
  void Start() {
    auto system = MakeSystem(scene_);
    system_ = std::move(system);
    guard_.emplace(*system_, scene_.retries);
    expected_ = system_->State().Size();
  }
  void Run(long steps) {
    for (long k = 0; k < steps && !system_->Trouble(); ++k) guard_->Step();
  }
  /// After a change of the system.
  void Mark() { guard_->Mark(); }

  Scene& Of() { return scene_; }
  ParticleSystemSPH& System() { return *system_; }
  /// Drops a block, if there is room.
  void Drop() {
    if (!system_->DropBlock().empty()) return;
    expected_ += system_->parameters.drop.particles;
    Mark();
  }

  /// The state as it is now as a start; `change` may spoil it.
  template <typename Change>
  void StartAgainWith(Change change) {
    auto start = std::make_shared<GivenStart>(GivenStart{system_->State(), system_->Density()});
    change(*start);
    const Scene before = scene_;
    scene_.base.given = start;
    try {
      Start();
    } catch (const UsageError&) {
      scene_ = before;
      throw;
    }
  }

  std::string Flaw() const {
    if (system_->State().Size() != expected_) {
      return fmt::format("{} particles of {}", system_->State().Size(), expected_);
    }
    if (system_->Trouble() && system_->Trouble()->limit.empty()) return "no cause is named";
    return FirstFlaw(*system_);
  }
  std::string Ending() const {
    if (system_->Trouble()) return "unstable: " + system_->Trouble()->limit;
    return guard_->Retreats() > 0 ? fmt::format("ok, undone and halved {} times", guard_->Retreats()) : "ok";
  }

 private:
  Scene scene_;
  std::unique_ptr<ParticleSystemSPH> system_;
  std::optional<Guard> guard_;
  std::size_t expected_ = 0;
};

constexpr long kBefore = 100;  // steps
constexpr long kAfter = 300;

double SoundOf(const ParticleSystemSPH& system) {
  const std::vector<double> density = system.Density();
  const double densest = density.empty() ? 1 : *std::ranges::max_element(density);
  return std::visit([&](const auto& equation) { return equation.SoundSpeed(densest); },
                    system.parameters_sph.equation_of_state);
}

/// The first wall on the right, pushed in to seven tenths of the fluid's width at a multiple of the speed of sound.
void Slam(Victim& victim, double over_sound) {
  victim.Run(kBefore);
  ParticleSystemSPH& system = victim.System();
  const auto wall = std::ranges::find(system.parameters.walls, FluidSide::kLeft, &Wall::fluid);
  if (wall == system.parameters.walls.end()) return;
  const Box fluid = victim.Of().base.fluid.region.Bounds();
  wall->lowest = fluid.x0 + 0.7 * fluid.Width();
  wall->velocity = -over_sound * SoundOf(system);
  victim.Mark();
  victim.Run(kAfter);
}

void DropBlocks(Victim& victim) {
  constexpr int kBlocks = 50;
  victim.Run(kBefore);
  ParticleSystemSPH& system = victim.System();
  system.parameters.particle_limit = 1'000'000;
  for (int k = 0; k < kBlocks; ++k) victim.Drop();
  victim.Run(kAfter);
}

void TurnGravity(Victim& victim) {
  victim.Run(kBefore);
  Parameters& parameters = victim.System().parameters;
  parameters.gravity = parameters.gravity == Vec2{} ? Vec2{0, 1000} : -10 * parameters.gravity;
  parameters.central_force *= -1;
  victim.Mark();
  victim.Run(kAfter);
}

/// Every particle twice, and twenty in one place.
void Coincide(Victim& victim) {
  victim.Run(kBefore);
  victim.StartAgainWith([](GivenStart& start) {
    const Particles once = start.particles;
    for (std::size_t i = 0; i < once.Size(); ++i) start.particles.Add(once.Position(i), once.Velocity(i), once.mass[i]);
    for (int k = 0; k < 20; ++k) start.particles.Add(once.Position(0), {}, once.mass[0]);
    start.density.clear();
  });
  victim.Run(kAfter);
}

void Shoot(Victim& victim) {
  victim.Run(kBefore);
  victim.StartAgainWith([](GivenStart& start) {
    constexpr double kSpeed = 1e6;  // [m/s]
    start.particles.vx[start.particles.Size() / 2] = kSpeed;
  });
  victim.Run(kAfter);
}

/// Writes another number over the first one with the bits of `value` in the state: a stray write.
void Overwrite(ParticleSystemSPH& system, double value, double other) {
  std::vector<std::byte> state;
  Archive writer = Archive::Writer(state, Archive::Extent::kPhysics);
  system.Transfer(writer);
  std::array<std::byte, sizeof value> pattern;
  std::memcpy(pattern.data(), &value, sizeof value);
  const auto found = std::search(state.begin(), state.end(), pattern.begin(), pattern.end());
  SPH_CHECK(found != state.end(), "{} is not in the state", value);
  std::memcpy(&*found, &other, sizeof other);
  Archive reader = Archive::Reader(state, Archive::Extent::kPhysics);
  system.Transfer(reader);
}

void PutIn(Victim& victim, double number) {
  victim.Run(kBefore);
  ParticleSystemSPH& system = victim.System();
  const std::size_t middle = system.State().Size() / 2;
  Overwrite(system, system.State().x[middle], number);
  victim.Run(kAfter);
  if (!system.Trouble()) Overwrite(system, system.State().vy_prev[middle], number);
  victim.Run(kAfter);
  if (!system.Trouble()) Overwrite(system, system.State().mass[middle], number);
  victim.Run(kAfter);
}

/// Every key that may change while the scene runs, to the ends of what it takes and beyond.
void JumpParameters(Victim& victim) {
  constexpr std::array kValues = {0.0, 1e-300, 1e-9, 0.5, 1.0, 20.0, 1e9, 1e300, -1.0, -1e300};
  constexpr long kSteps = 12;
  for (const SceneKey& key : AllSceneKeys()) {
    if (key.when != When::kAnyTime) continue;
    for (const double value : kValues) {
      victim.Start();
      Scene scene = victim.Of();
      victim.Run(kSteps);
      try {
        SetWhileRunning(scene, victim.System(), key.name, value);
      } catch (const UsageError&) {
        continue;  // refused, as it should be
      }
      victim.Mark();
      victim.Run(kSteps);
      victim.Drop();
      victim.Run(kSteps);
      if (const std::string flaw = victim.Flaw(); !flaw.empty()) {
        throw TroubleError("{} = {}: {}", key.name, value, flaw);
      }
    }
  }
}

/// From each solver to each other and back, with the particles as they are.
void SwitchSolver(Victim& victim) {
  const auto halve = [](Scene& scene, bool from, bool to) {  // h is mueller's support
    if (from != to) scene.sph.smoothing_length *= to ? 2.0 : 0.5;
  };
  for (const char* solver : {"delta", "mueller", "paper", "mueller", "delta", "paper", "delta"}) {
    victim.Run(kBefore);
    Scene& scene = victim.Of();
    const Scene before = scene;
    halve(scene, scene.solver == "mueller", std::string(solver) == "mueller");
    scene.solver = solver;
    if (scene.base.wall.SeenByFluid() && scene.solver != "delta") scene.base.wall.kind = WallKind::kReflect;
    try {
      victim.StartAgainWith([](GivenStart&) {});
    } catch (const UsageError&) {
      scene = before;  // a gas so dense is no liquid: the solver that there was goes on
    }
  }
  victim.Run(kAfter);
}

void CutAway(Victim& victim, std::size_t left) {
  victim.Run(kBefore);
  victim.StartAgainWith([left](GivenStart& start) {
    Particles few;
    for (std::size_t i = 0; i < left; ++i) {
      few.Add(start.particles.Position(i), start.particles.Velocity(i), start.particles.mass[i]);
    }
    start = {few, {}};
  });
  victim.Run(kAfter);
  victim.Drop();
  victim.Run(kAfter);
}

void TakeLongSteps(Victim& victim) {
  victim.Run(kBefore);
  victim.System().parameters.time_step *= 1000;
  victim.Mark();
  victim.Run(kAfter);
}

struct Treatment {
  std::string name;
  std::function<void(Victim&)> apply;
  bool of_walls = false;  ///< needs a wall on the right
};

std::vector<Treatment> Treatments() {
  return {
      {"wall slammed in at 0.1 c", [](Victim& v) { Slam(v, 0.1); }, true},
      {"wall slammed in at c", [](Victim& v) { Slam(v, 1); }, true},
      {"wall slammed in at 10 c", [](Victim& v) { Slam(v, 10); }, true},
      {"wall slammed in at 100 c", [](Victim& v) { Slam(v, 100); }, true},
      {"50 blocks dropped at once", &DropBlocks},
      {"forces turned round, gravity tenfold", &TurnGravity},
      {"every particle twice, twenty in one place", &Coincide},
      {"one particle at 1e6 m/s", &Shoot},
      {"not a number put in", [](Victim& v) { PutIn(v, std::nan("")); }},
      {"infinity put in", [](Victim& v) { PutIn(v, std::numeric_limits<double>::infinity()); }},
      {"parameters jumped over their whole range", &JumpParameters},
      {"solver switched seven times", &SwitchSolver},
      {"all but one particle cut away", [](Victim& v) { CutAway(v, 1); }},
      {"all particles cut away", [](Victim& v) { CutAway(v, 0); }},
      {"step a thousand times as long", &TakeLongSteps},
  };
}

struct RoughScene {
  std::string name;
  std::size_t particles;
  std::vector<std::string> settings = {};
};

const std::vector<RoughScene> kScenes = {
    {"dam-break", 600},
    {"dam-break", 600, {"method.precision=float", "method.step=adaptive"}},
    {"mueller", 500},
    {"water-column", 800, {"method.precision=double"}},
    {"water-column", 800, {"method.step=fixed", "walls.kind=penalty", "walls.stiffness=4e6", "walls.damping=2000"}},
    {"breathing-star", 500},
    {"taylor-green", 625, {"method.step=adaptive"}},
};

std::string Title(const RoughScene& of, const Scene& scene) {
  std::string title = fmt::format("{} ({})", of.name, scene.solver);
  for (const std::string& setting : of.settings) title += " " + setting.substr(setting.find('=') + 1);
  return title;
}

/// The flaw that a treatment has shown; empty if it has shown none.
std::string Try(const Treatment& treatment, Victim& victim) {
  try {
    treatment.apply(victim);
    return victim.Flaw();
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

void StressRough(const StressOptions& options, StressSink& sink) {
  for (const Treatment& treatment : Treatments()) {
    for (const RoughScene& of : kScenes) {
      if (sink.Stopped()) return;
      SceneRequest request;
      request.scene = of.name;
      request.settings = of.settings;
      request.particles = of.particles;
      request.seed = options.FirstSeed();
      request.threads = options.threads;
      const Scene scene = LoadScene(request);
      const auto& walls = scene.base.walls;
      if (treatment.of_walls && std::ranges::find(walls, FluidSide::kLeft, &Wall::fluid) == walls.end()) continue;
      const std::string what = fmt::format("{}: {}", Title(of, scene), treatment.name);
      sink.Note("rough: " + what);
      Victim victim(scene);
      const std::string flaw = Try(treatment, victim);
      sink.Row({what, "flaws", flaw.empty() ? 0.0 : 1.0, 0, flaw.empty() ? victim.Ending() : flaw});
    }
  }
}

}  // namespace sph
