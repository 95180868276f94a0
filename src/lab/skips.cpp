#include "lab/skips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "particles/diagnostics.hpp"
#include "scenes/build.hpp"
#include "scenes/request.hpp"
#include "scenes/scene_file.hpp"

namespace sph {
namespace {

using System = std::shared_ptr<ParticleSystemSPH>;

constexpr long kSteps = 30;  // of a repetition of a tank

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
Arm Steps(std::string what, const System& system, std::function<void(ParticleSystemSPH&)> also = {}) {
  const auto run = [system, also] {
    const Stopwatch watch;
    for (long step = 0; step < kSteps; ++step) {
      system->Step();
      if (also) also(*system);
    }
    return 1e9 * watch.Seconds() / static_cast<double>(kSteps * static_cast<long>(system->State().Size()));
  };
  const auto error = [system] {
    if (system->Trouble()) throw TroubleError("bench: the flow broke down: {}", system->Trouble()->Message());
    system->ComputeFields();
    return ErrorsAgainstScalarTwin(*system).acceleration;
  };
  return {std::move(what), run, error};
}

constexpr const char* kTwin = "acceleration, against scalar double";
constexpr const char* kNs = "ns per particle and step";

Comparison Lists(std::size_t n) {
  const System anew = WarmTank(Tank(n));
  anew->KeepLists(false);
  return {"neighbour lists", kNs, Steps("made anew at every step", anew),
          Steps("kept while they hold", WarmTank(Tank(n))), kTwin};
}

/// Without walls there is nothing that carries water: no gravity either.
Comparison Walls(std::size_t n) {
  Scene free = Tank(n);
  free.base.walls.clear();
  free.base.gravity = {};
  return {"walls", kNs, Steps("three, carrying the water", WarmTank(Tank(n))),
          Steps("none, no gravity", WarmTank(free)), kTwin};
}

/// Only where the last step noted a particle behind a wall are walls looked at. A wall that was moved by hand makes all
/// notes void: a ceiling far away that is moved to and fro.
Comparison WallsWhereParticlesAre(std::size_t n) {
  Scene scene = Tank(n);
  scene.base.walls.push_back({"ceiling", FluidSide::kBelow, 10, 0, 10, 11});
  const auto move_ceiling = [](ParticleSystemSPH& system) {
    double& at = system.parameters.walls.back().at;
    at = at == 10 ? 11 : 10;
  };
  return {"walls looked at", kNs, Steps("for every particle", WarmTank(scene), move_ceiling),
          Steps("where particles are", WarmTank(scene)), kTwin};
}

/// The same water in the tutorial's solver, which has viscosity.
Scene MuellersTank(std::size_t n, double viscosity) {
  Scene scene = Tank(n);
  const auto water = std::get<Tait>(scene.sph.equation_of_state);
  scene.solver = "mueller";
  scene.sph.smoothing_length *= CubicSpline<2>::kSupport;  // there it is the support
  scene.sph.equation_of_state = IdealGas{std::pow(water.SoundSpeed(water.rho0), 2), water.rho0};
  scene.sph.viscosity = viscosity;
  return scene;
}

/// The greatest distance of a particle of one system from the same one of the other, in spacings.
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
  const auto apart = [viscous, inviscid] { return Apart(*viscous, *inviscid); };
  Comparison comparison{"viscosity, solver mueller", kNs, Steps("1e-12 Pa s", viscous), Steps("0", inviscid),
                        "particles apart [spacings]"};
  comparison.with.error = comparison.without.error = apart;
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
  return {"masses", kNs, Steps("one heavier by 1e-16", unequal), Steps("equal", WarmTank(Tank(n))), kTwin};
}

Comparison EnergiesAndMomenta(std::size_t n) {
  return {"diagnostics", kNs,
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
  return {"drawing, by speed, on no screen", kNs,
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
    Press("d", scene);
    RunUntil(kEnd);
    return watch.Seconds() / kEnd;
  }
  double Deepest() const { return Diagnose(*system_).deepest; }

 private:
  void RunUntil(double time) {
    while (system_->Time() < time && !system_->Trouble()) system_->Step();
    if (system_->Trouble()) throw TroubleError("bench: the dam broke down: {}", system_->Trouble()->Message());
  }

  void Press(const std::string& key, Scene& scene) {
    for (const SceneControl& control : scene.controls) {
      if (control.press != key) continue;
      for (const auto& action : control.actions) {
        if (const auto* move = std::get_if<MoveWallAction>(&action)) {
          FindWall(scene.base.walls, move->wall)->at = move->to;
        } else {
          SetWhileRunning(scene, std::get<SetAction>(action).key, std::get<SetAction>(action).to);
        }
      }
    }
    system_->parameters.walls = scene.base.walls;
    system_->parameters.motion_damping = scene.base.motion_damping;
  }

  std::vector<std::string> settings_;
  System system_;
};

Arm Dam(std::string what, std::vector<std::string> settings) {
  const auto dam = std::make_shared<DamBreak>(std::move(settings));
  return {std::move(what), [dam] { return dam->Run(); }, [dam] { return dam->Deepest(); }};
}

Comparison AdaptiveStep() {
  return {"time step, scene dam-break", "s per simulated second", Dam("the published one", {}),
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

std::vector<std::function<Comparison()>> SkipComparisons(bool quick) {
  const std::size_t n = quick ? 10'000 : 100'000;
  std::vector<std::function<Comparison()>> comparisons;
  for (const auto make :
       {&Lists, &Walls, &WallsWhereParticlesAre, &Viscosity, &Masses, &EnergiesAndMomenta, &Drawing}) {
    comparisons.emplace_back([make, n] { return make(n); });
  }
  comparisons.emplace_back(&AdaptiveStep);
  return comparisons;
}

int SkipRepetitions(bool quick) { return quick ? 5 : 9; }

std::string SkipsAsCsv(std::span<const SkipResult> results) {
  std::string text =
      "mechanism,with,without,unit,repetitions,with_least,with_median,with_greatest,without_least,without_median,"
      "without_greatest,ratio,error,error_with,error_without\n";
  for (const SkipResult& r : results) {
    text += fmt::format("\"{}\",\"{}\",\"{}\",{},{}", r.mechanism, r.what_with, r.what_without, r.unit, r.repetitions);
    for (const double value : {r.with.least, r.with.median, r.with.greatest, r.without.least, r.without.median,
                               r.without.greatest, r.Ratio()}) {
      text += fmt::format(",{:.6g}", value);
    }
    text += fmt::format(",\"{}\",{:.3g},{:.3g}\n", r.error, r.error_with, r.error_without);
  }
  return text;
}

std::string SkipsTableHead() {
  return "least of the repetitions, which took turns, and the median in brackets; ns of a particle and step where no\n"
         "unit is named\n\n";
}

std::string SkipsTableRow(const SkipResult& r) {
  const bool ns = r.unit == kNs;
  const auto line = [&](const std::string& what, const Spread& time, double error) {
    return fmt::format("  {:<28} {:>9.4g} ({:.4g}){} {}: {:.2g}\n", what, time.least, time.median,
                       ns ? "" : " " + r.unit, r.error, error);
  };
  return fmt::format("{}: {:.2f} times as fast without\n", r.mechanism, r.Ratio()) +
         line(r.what_with, r.with, r.error_with) + line(r.what_without, r.without, r.error_without);
}

}  // namespace sph
