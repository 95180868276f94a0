#include "lab/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sph {
namespace {

constexpr const char* kStarDensity = "exact density of the static star";

std::vector<Verdict> StarOfEqualMasses(ParticleSystemSPH& system) {
  return MeasureStaticStar(system, 3e-5,
                           fmt::format("{}; the paper reports 0.04, its method gives 2.3e-3", kStarDensity));
}
std::vector<Verdict> StarOfGradedMasses(ParticleSystemSPH& system) {
  return MeasureStaticStar(system, 2e-6, fmt::format("{}; best elsewhere 5.0e-6", kStarDensity));
}

SceneRequest Named(const std::string& name, std::vector<std::string> settings = {}) {
  SceneRequest request;
  request.scene = name;
  request.settings = std::move(settings);
  return request;
}

SceneRequest CoarseVortices() {
  SceneRequest request = Named("taylor-green");
  request.particles = 625;
  return request;
}

SceneRequest CoarseImpact() {
  SceneRequest request = Named("wall-impact");
  request.particles = 3200;
  return request;
}

SceneRequest AccurateStar(std::vector<std::string> settings) {
  SceneRequest request = Named("toy-star", std::move(settings));
  request.solver = "delta";
  request.particles = 3000;
  return request;
}

}  // namespace

std::span<const VerificationCase> AllVerificationCases() {
  static const std::array cases = {
      VerificationCase{"toy-star", "static star, random start, equal masses", false,
                       // damped twice as much as in Table I, with which it still swings at t = 20 s
                       AccurateStar({"method.smoothing_length=0.08", "forces.damping=1"}), &StarOfEqualMasses},
      VerificationCase{"graded-star", "static star, hexagonal start, masses graded with density", false,
                       AccurateStar({"method.kernel=quintic", "method.smoothing_length=0.04", "fluid.arrange=hexagonal",
                                     "fluid.masses=graded", "fluid.flow=star"}),
                       &StarOfGradedMasses},
      VerificationCase{"breathing-star", "ten periods of a star that swells and shrinks", false,
                       Named("breathing-star"), &MeasureBreathingStar},
      VerificationCase{"elliptic-star", "five periods of a star that stretches along x and y in turn", false,
                       Named("elliptic-star"), &MeasureEllipticStar},
      VerificationCase{"taylor-green", "decaying vortices, Re = 100, 50 x 50", false, Named("taylor-green"),
                       &MeasureTaylorGreen, &kTaylorGreen},
      VerificationCase{"vortices-order", "order of convergence of taylor-green, 25 x 25 to 100 x 100", true,
                       CoarseVortices(), &MeasureTaylorGreenOrder, nullptr, false},
      VerificationCase{"operators", "kernels and sums over particles against exact derivatives, 25 x 25 to 100 x 100",
                       false, FrozenVortices("lattice", 10'000, "0"), &MeasureOperators, nullptr, false},
      VerificationCase{"momentum", "vortices, with pressure forces in pairs", false,
                       Named("taylor-green", {"method.sharp_gradient=off", "method.tensile_control=off"}),
                       &MeasureMomentum, nullptr, false},
      VerificationCase{"reversal", "a stretched star that goes back the way it came", false, Named("elliptic-star"),
                       &MeasureReversal, nullptr, false},
      VerificationCase{"elliptic-drop", "a drop that becomes an ellipse, R/dx = 40", false, Named("elliptic-drop"),
                       &MeasureEllipticDrop, &kEllipticDrop},
      VerificationCase{"still-water", "a tank at rest, H/dx = 45", false, Named("still-water"), &MeasureStillWater,
                       &kStillWater},
      VerificationCase{"wall-particles", "the same tank, with particles behind its walls in place of mirrors", false,
                       Named("still-water", {"walls.kind=particles"}), &MeasureStillWater, nullptr, false},
      VerificationCase{"poiseuille", "flow between plates from start-up on, 60 across", true, Named("poiseuille"),
                       &MeasurePoiseuille, &kPoiseuille},
      VerificationCase{"couette", "a plate that drags a fluid along, from start-up on, 60 across", true,
                       Named("couette"), &MeasureCouette},
      VerificationCase{"water-column", "front of a breaking column a x 2a, 10 000 particles", true,
                       Named("water-column"), &MeasureWaterColumn, &kWaterColumn},
      VerificationCase{"measured-front", "the same front against experiments, which are late", true,
                       Named("water-column"), &MeasureMeasuredFront, nullptr, false},
      VerificationCase{"oscillating-drop", "a drop under a central force, three periods, R/dx = 50", true,
                       Named("oscillating-drop"), &MeasureOscillatingDrop},
      VerificationCase{"capillary-drop", "a drop that swings by its surface tension, R/dx = 25", false,
                       Named("capillary-drop", {"fluid.flow_speed=0.1"}), &MeasureCapillaryDrop, nullptr, false},
      VerificationCase{"rotating-square", "a square that throws out arms, L/dx = 100", true, Named("rotating-square"),
                       &MeasureRotatingSquare},
      VerificationCase{"standing-wave", "a wave between walls for eight periods, Re = 250, H/dx = 50", true,
                       Named("standing-wave"), &MeasureStandingWave},
      VerificationCase{"wall-arrival", "a dam break 2H x H without friction runs to the far wall, H/dx = 80", true,
                       Named("wall-impact", {"walls.layer_viscosity=0"}), &MeasureWallArrival},
      VerificationCase{"wall-impact", "the same with friction hits the wall, and what a gauge there feels", true,
                       Named("wall-impact"), &MeasureWallImpact},
      VerificationCase{"wall-pressure", "the same, H/dx = 40, and a gauge higher up the wall of another experiment",
                       true, CoarseImpact(), &MeasureWallPressure, nullptr, false},
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
