#include "lab/skips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "particles/diagnostics.hpp"
#include "particles/guard.hpp"
#include "scenes/build.hpp"
#include "scenes/changes.hpp"
#include "scenes/request.hpp"

namespace sph {
namespace {

using System = std::shared_ptr<ParticleSystemSPH>;

Scene Tank(std::size_t particles) {
  Scene scene = SpeedScene(Flow::kTank, particles, Precision::kFloat);
  scene.base.threads = 1;
  return scene;
}

System WarmTank(const Scene& scene) {
  System system = MakeSystem(scene);
  WarmUp(*system, Flow::kTank);
  return system;
}

/// Steps of a system, after each of which something else is done; ns of a particle and step.
Arm Steps(std::string what, const System& system, const std::function<void(ParticleSystemSPH&)>& also = {}) {
  constexpr std::size_t kParticleSteps = 3'000'000;  // of a repetition
  constexpr std::size_t kMostSteps = 300;
  const std::size_t steps = std::min(kMostSteps, kParticleSteps / system->State().Size());
  const auto run = [system, also, steps] {
    const Stopwatch watch;
    for (std::size_t step = 0; step < steps; ++step) {
      system->Step();
      if (also) also(*system);
    }
    return 1e9 * watch.Seconds() / static_cast<double>(steps * system->State().Size());
  };
  const auto error = [system] {
    if (system->Trouble()) throw TroubleError("bench: the flow broke down: {}", system->Trouble()->Message());
    system->ComputeFields();
    return ErrorsAgainstScalarTwin(*system).density;
  };
  return {std::move(what), run, error};
}

constexpr const char* kTwin = "density against scalar double";

Comparison Lists(std::size_t n) {
  const System anew = WarmTank(Tank(n));
  anew->KeepLists(false);
  return {"neighbour lists", kNsOfAStep, Steps("made anew at every step", anew),
          Steps("kept while they hold", WarmTank(Tank(n))), kTwin};
}

/// A smaller tank, where more of the particles are at walls, in which the water has come to stand on them.
System SettledTank(const Scene& scene) {
  System system = WarmTank(scene);
  while (system->Time() < 0.5 * TimeScale()) system->Step();
  return system;
}

/// Without walls there is nothing that carries water: no gravity either.
Comparison Walls(std::size_t n) {
  Scene free = Tank(n / 10);
  free.base.walls.clear();
  free.base.gravity = {};
  return {"walls", kNsOfAStep, Steps("three that carry the water", SettledTank(Tank(n / 10))),
          Steps("none and no gravity", SettledTank(free)), kTwin};
}

/// Only where the last step noted a particle behind a wall are walls looked at. A wall that was moved by hand makes all
/// notes void: a ceiling far away that is moved to and fro.
Comparison WallsWhereParticlesAre(std::size_t n) {
  Scene scene = Tank(n / 10);
  scene.base.walls.push_back({"ceiling", FluidSide::kBelow, 10, 0, 10, 11});
  const auto move_ceiling = [](ParticleSystemSPH& system) {
    double& at = system.parameters.walls.back().at;
    at = at == 10 ? 11 : 10;
  };
  return {"walls looked at", kNsOfAStep, Steps("for every particle", SettledTank(scene), move_ceiling),
          Steps("where particles are", SettledTank(scene)), kTwin};
}

/// The same water in the tutorial's solver, which has viscosity. Without it that water boils, unless damped.
Scene MuellersTank(std::size_t n, double viscosity) {
  Scene scene = Tank(n);
  const auto water = std::get<Tait>(scene.sph.equation_of_state);
  scene.solver = "mueller";
  scene.sph.smoothing_length *= CubicSpline<2>::kSupport;  // there it is the support
  scene.sph.equation_of_state = IdealGas{std::pow(water.SoundSpeed(water.rho0), 2), water.rho0};
  scene.sph.viscosity = viscosity;
  scene.base.motion_damping = 0.1 / scene.base.time_step;
  return scene;
}

/// The greatest distance of a particle of one system from the same one of the other, in spacings. In the long run
/// round-off decides how a lattice falls apart, so that it means something only early.
double Apart(const ParticleSystemSPH& a, const ParticleSystemSPH& b) {
  const auto by_id = [](const Particles& p) {
    std::vector<Vec2> position(p.Size());
    for (std::size_t i = 0; i < p.Size(); ++i) position[p.id[i]] = p.Position(i);
    return position;
  };
  const std::vector<Vec2> of_a = by_id(a.State()), of_b = by_id(b.State());
  double greatest = 0;
  for (std::size_t id = 0; id < of_a.size(); ++id) greatest = std::max(greatest, Length(of_a[id] - of_b[id]));
  return greatest / a.InitialSpacing();
}

Comparison Viscosity(std::size_t n) {
  constexpr double kNothing = 1e-12;  // [Pa s], which does nothing but has to be computed
  const System viscous = WarmTank(MuellersTank(n, kNothing));
  const System inviscid = WarmTank(MuellersTank(n, 0));
  const double apart = Apart(*viscous, *inviscid);
  Comparison comparison{"viscosity in solver mueller", kNsOfAStep, Steps("1e-12 Pa s", viscous), Steps("0", inviscid),
                        "apart after 60 steps [spacings]"};
  comparison.with.error = comparison.without.error = [apart] { return apart; };
  return comparison;
}

/// The tank with one particle that is heavier by round-off.
class NearlyEqualMasses final : public ParticleSystemSPH {
 public:
  explicit NearlyEqualMasses(const Scene& scene) : ParticleSystemSPH(CompleteParameters(scene), scene.sph) { Reset(); }

 protected:
  void InitialPositions() override {
    ParticleSystemSPH::InitialPositions();
    particles_.mass[0] = std::nextafter(particles_.mass[0], 2 * particles_.mass[0]);
  }
};

Comparison Masses(std::size_t n) {
  const auto unequal = std::make_shared<NearlyEqualMasses>(Tank(n));
  WarmUp(*unequal, Flow::kTank);
  return {"masses", kNsOfAStep, Steps("one heavier by 1e-16", unequal), Steps("equal", WarmTank(Tank(n))), kTwin};
}

/// The guard notes the state now and then, and looks after every step whether there is trouble.
Comparison Guarded(std::size_t most) {
  const std::size_t n = most / 10;
  const System system = WarmTank(Tank(n));
  const auto guard = std::make_shared<Guard>(*system, 3);
  const System alone = WarmTank(Tank(n));
  const auto time = [](const System& of, const std::function<void()>& step) -> std::function<double()> {
    return [of, step] {
      constexpr long kSteps = 2 * Guard::kStepsApart;  // as many notes as in the long run
      const Stopwatch watch;
      for (long k = 0; k < kSteps; ++k) step();
      return 1e9 * watch.Seconds() / (static_cast<double>(kSteps) * static_cast<double>(of->State().Size()));
    };
  };
  Comparison comparison{"guard", kNsOfAStep, Steps("states kept to go back to", system), Steps("none", alone), kTwin};
  comparison.with.run = time(system, [guard] { guard->Step(); });
  comparison.without.run = time(alone, [alone] { alone->Step(); });
  return comparison;
}

Comparison EnergiesAndMomenta(std::size_t n) {
  return {"diagnostics", kNsOfAStep,
          Steps("at every step", WarmTank(Tank(n)), [](ParticleSystemSPH& system) { Diagnose(system); }),
          Steps("never", WarmTank(Tank(n))), kTwin};
}

/// What reaches the screen's side without a screen.
class CountingCanvas final : public Canvas {
 public:
  Colouring WantedColouring() const override { return Colouring::kSpeed; }
  void DrawDisks(std::span<const double> x, std::span<const double>, double, std::span<const double>) override {
    disks_ += x.size();
  }
  void DrawWall(Vec2, Vec2) override { ++walls_; }

 private:
  std::size_t disks_ = 0, walls_ = 0;
};

Comparison Drawing(std::size_t n) {
  const auto canvas = std::make_shared<CountingCanvas>();
  return {"drawing on no screen", kNsOfAStep,
          Steps("at every step", WarmTank(Tank(n)), [canvas](ParticleSystemSPH& system) { system.Draw(*canvas); }),
          Steps("never", WarmTank(Tank(n))), kTwin};
}

/// Table II's dam settles, breaks and sloshes.
class DamBreak {
 public:
  explicit DamBreak(std::vector<std::string> settings) : settings_(std::move(settings)) {}

  /// Wall seconds of a simulated second.
  double Run() {
    constexpr double kBreak = 4, kEnd = 8;  // [s]
    SceneRequest request;
    request.settings = settings_;
    request.threads = 1;
    Scene scene = LoadScene(request);
    system_ = MakeSystem(scene);
    const Stopwatch watch;
    RunUntil(kBreak);
    PressSceneKey("d", scene, *system_);
    RunUntil(kEnd);
    return watch.Seconds() / kEnd;
  }
  double Deepest() const { return Diagnose(*system_).deepest; }

 private:
  void RunUntil(double time) {
    while (system_->Time() < time && !system_->Trouble()) system_->Step();
    if (system_->Trouble()) throw TroubleError("bench: the dam broke down: {}", system_->Trouble()->Message());
  }

  std::vector<std::string> settings_;
  System system_;
};

Arm Dam(std::string what, std::vector<std::string> settings) {
  const auto dam = std::make_shared<DamBreak>(std::move(settings));
  return {std::move(what), [dam] { return dam->Run(); }, [dam] { return dam->Deepest(); }};
}

Comparison AdaptiveStep() {
  return {"time step of scene dam-break", "s per simulated second", Dam("the published one", {}),
          Dam("adaptive", {"method.step='adaptive'"}), "deepest in a wall [spacings]"};
}

}  // namespace

SkipResult Measure(const Comparison& comparison, int repetitions) {
  std::vector<double> with, without;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    with.push_back(comparison.with.run());
    without.push_back(comparison.without.run());
  }
  return {comparison.mechanism,      comparison.unit,  comparison.with.what,
          comparison.without.what,   repetitions,      SpreadOf(with),
          SpreadOf(without),         comparison.error, comparison.with.error(),
          comparison.without.error()};
}

std::vector<std::function<Comparison()>> SkipComparisons(std::size_t n) {
  std::vector<std::function<Comparison()>> comparisons;
  for (const auto make :
       {&Lists, &Walls, &WallsWhereParticlesAre, &Viscosity, &Masses, &Guarded, &EnergiesAndMomenta, &Drawing}) {
    comparisons.emplace_back([make, n] { return make(n); });
  }
  comparisons.emplace_back(&AdaptiveStep);
  return comparisons;
}

}  // namespace sph
