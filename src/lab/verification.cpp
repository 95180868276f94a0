#include "lab/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sph {
namespace {

constexpr const char* kStarDensity = "exact density of the static star";

std::vector<Verdict> StarOfEqualMasses(ParticleSystemSPH& system) {
  return MeasureStaticStar(system, 1e-5,
                           fmt::format("{}; the paper reports 0.04, its method gives 2.3e-3", kStarDensity));
}
std::vector<Verdict> StarOfGradedMasses(ParticleSystemSPH& system) {
  return MeasureStaticStar(system, 3e-6, fmt::format("{}; best elsewhere 5.0e-6", kStarDensity));
}

SceneRequest Named(const std::string& name, std::vector<std::string> settings = {}) {
  SceneRequest request;
  request.scene = name;
  request.settings = std::move(settings);
  return request;
}

SceneRequest WithParticles(SceneRequest request, std::size_t particles) {
  request.particles = particles;
  return request;
}

SceneRequest AccurateStar(std::vector<std::string> settings) {
  SceneRequest request = WithParticles(Named("toy-star", std::move(settings)), 3000);
  request.solver = "delta";
  return request;
}

}  // namespace

std::span<const VerificationCase> AllVerificationCases() {
  const std::vector<double> down = {1.0 / 16, 0.25, 1};  // where 4 N takes minutes
  const std::vector<double> viscous = {0.25, 1, 2.25};   // where the time goes with N^2
  using Case = VerificationCase;
  static const std::array cases = {
      Case{"toy-star", "static star, random start, equal masses", false,
           // damped twice as much as in Table I, with which it still swings at t = 20 s
           AccurateStar({"forces.damping=1"}), &StarOfEqualMasses},
      Case{"graded-star", "static star, hexagonal start, masses graded with density", false,
           AccurateStar({"fluid.arrange=hexagonal", "fluid.masses=graded", "fluid.flow=star"}), &StarOfGradedMasses},
      Case{"breathing-star", "ten periods of a star that swells and shrinks", false, Named("breathing-star"),
           &MeasureBreathingStar},
      Case{"elliptic-star", "five periods of a star that stretches along x and y in turn", false,
           Named("elliptic-star"), &MeasureEllipticStar},
      Case{"taylor-green", "decaying vortices, Re = 100, 50 x 50", false, Named("taylor-green"), &MeasureTaylorGreen,
           &kTaylorGreen},
      Case{"shear-wave", "a wave of shear at 45 degrees, Re = 100, 50 x 50", false,
           Named("taylor-green", {"fluid.flow=shear-wave"}), &MeasureShearWave},
      Case{"operators", "kernels and sums over particles against exact derivatives", false,
           WithParticles(Named("taylor-green", {"fluid.arrange=lattice", "forces.viscosity=0"}), 10'000),
           &MeasureOperators, nullptr, false, &Freeze},
      Case{"momentum", "vortices, with pressure forces in pairs", false, Named("taylor-green"), &MeasureMomentum,
           nullptr, false},
      Case{"reversal", "a stretched star that goes back the way it came", false, Named("elliptic-star"),
           &MeasureReversal, nullptr, false},
      Case{"elliptic-drop", "a drop that becomes an ellipse, R/dx = 40", false, Named("elliptic-drop"),
           &MeasureEllipticDrop, &kEllipticDrop},
      Case{"still-water", "a tank at rest, H/dx = 45", false, Named("still-water"), &MeasureStillWater, &kStillWater},
      Case{"wall-particles", "the same tank, with particles behind its walls in place of mirrors", false,
           Named("still-water", {"walls.kind=particles"}), &MeasureTankOfParticles, nullptr, false},
      Case{"rest-relaxed", "the same tank, from random but even places", true,
           Named("still-water", {"fluid.arrange=relaxed"}), &MeasureRest, nullptr, false, nullptr, down},
      Case{"rest-perturbed", "the same tank, from a lattice perturbed by a tenth of its spacing", true,
           Named("still-water", {"fluid.arrange=perturbed", "fluid.jitter=0.002"}), &MeasureRest, nullptr, false,
           nullptr, down},
      Case{"rest-odd-width", "a tank 0.31 m wide, which 15.5 columns of a lattice fill", false,
           Named("still-water", {"fluid.region.box=[0, 0, 0.31, 0.9]", "fluid.particles=697", "wall.right.at=0.31"}),
           &MeasureRest, nullptr, false},
      Case{"rest-tilted", "a closed tank 1 m wide under gravity tilted by 30 degrees", true,
           Named("still-water", {"fluid.region.box=[0, 0, 1, 0.9]", "fluid.particles=2250", "wall.right.at=1",
                                 "forces.gravity=[0.5, -0.8660254037844386]", "fluid.flow=rest", "fluid.masses=equal"}),
           &MeasureTiltedRest, nullptr, false, &CloseTank, down},
      Case{"poiseuille", "flow between plates from start-up on, 60 across", false, Named("poiseuille"),
           &MeasurePoiseuille, &kPoiseuille, true, nullptr, viscous},
      Case{"poiseuille-relaxed", "the same, from random but even places", true,
           Named("poiseuille", {"fluid.arrange=relaxed"}), &MeasureDisorderedPoiseuille, nullptr, false, nullptr,
           viscous},
      Case{"poiseuille-steady",
           "the same from a lattice, fifty times as long",
           true,
           Named("poiseuille"),
           &MeasureSteadyPoiseuille,
           nullptr,
           false,
           nullptr,
           {0.25, 0.36, 1}},
      Case{"couette", "a plate that drags a fluid along, from start-up on, 60 across", false, Named("couette"),
           &MeasureCouette, nullptr, true, nullptr, viscous},
      Case{"couette-relaxed", "the same, from random but even places", true,
           Named("couette", {"fluid.arrange=relaxed"}), &MeasureDisorderedCouette, nullptr, false, nullptr, viscous},
      Case{"couette-back", "the same, the plate sliding the other way", true,
           Named("couette", {"fluid.arrange=relaxed", "wall.floor.tangential_velocity=-1"}), &MeasureDisorderedCouette,
           nullptr, false, nullptr, viscous},
      Case{"cavity", "a lid drags a fluid round in its box, Re = 100, 64 x 64", true, Named("lid-driven-cavity"),
           &MeasureCavity, &kCavity, false},
      Case{"cavity-drift", "the same for a hundred times of the lid's way", true, Named("lid-driven-cavity"),
           &MeasureCavityDrift, nullptr, false, nullptr, down},
      Case{"water-column", "front of a breaking column a x 2a, 10 000 particles", false, Named("water-column"),
           &MeasureWaterColumn, &kWaterColumn},
      Case{"column-noise", "the same until it comes back from the far wall", true, Named("water-column"),
           &MeasureColumnNoise, nullptr, false},
      Case{"front-convergence", "the same front with 2500, 10 000 and 40 000 particles", true, Named("water-column"),
           &MeasureFrontConvergence, nullptr, false},
      Case{"measured-front", "the same front against experiments, which are late", true, Named("water-column"),
           &MeasureMeasuredFront, nullptr, false},
      Case{"oscillating-drop", "a drop under a central force, three periods, R/dx = 50", true,
           Named("oscillating-drop"), &MeasureOscillatingDrop},
      Case{"capillary-drop", "a drop that swings by its surface tension, R/dx = 25", false,
           Named("capillary-drop", {"fluid.flow_speed=0.1"}), &MeasureCapillaryDrop, nullptr, false},
      Case{"rotating-square", "a square that throws out arms, L/dx = 100", true, Named("rotating-square"),
           &MeasureRotatingSquare},
      Case{"standing-wave", "a wave between walls for eight periods, Re = 250, H/dx = 50", true, Named("standing-wave"),
           &MeasureStandingWave, nullptr, true, nullptr, down},
      Case{"wall-arrival", "a dam break 2H x H without friction runs to the far wall, H/dx = 80", true,
           Named("wall-impact", {"walls.layer_viscosity=0"}), &MeasureWallArrival},
      Case{"wall-impact", "the same with friction hits the wall, and what a gauge there feels", true,
           Named("wall-impact"), &MeasureWallImpact},
      Case{"wall-pressure", "the same, H/dx = 40, and a gauge higher up the wall of another experiment", true,
           WithParticles(Named("wall-impact"), 3200), &MeasureWallPressure, nullptr, false},
  };
  return cases;
}

void AdvanceTo(ParticleSystemSPH& system, double time) {
  constexpr double kRoundOff = 1e-6;  // of a step
  while (system.Time() < time - kRoundOff * system.parameters.time_step && !system.Trouble()) system.Step();
}

std::vector<Verdict> Judge(const Judgement& judgement, ParticleSystemSPH& system) {
  std::vector<FlowSnapshot> snapshots;
  for (const double time : judgement.times(system)) {
    AdvanceTo(system, time);
    if (system.Trouble()) return judgement.judge(system, {});
    system.ComputeFields();
    snapshots.push_back({system.Time(), system.State(), system.Pressure()});
  }
  return judgement.judge(system, snapshots);
}

Vec2 SecondMoments(const Particles& particles) {
  Vec2 sum;
  for (std::size_t i = 0; i < particles.Size(); ++i) {
    sum = sum + particles.mass[i] * Vec2{particles.x[i] * particles.x[i], particles.y[i] * particles.y[i]};
  }
  return sum;
}

}  // namespace sph
