#include "lab/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sph {
namespace {

constexpr const char* kStar = "exact density of the static star";

std::vector<Verdict> StarOfEqualMasses(ParticleSystemSPH& system) {
  return MeasureStaticStar(system, 3e-5, fmt::format("{}; the paper reports 0.04, its method gives 2.3e-3", kStar));
}
std::vector<Verdict> StarOfGradedMasses(ParticleSystemSPH& system) {
  return MeasureStaticStar(system, 2e-6, fmt::format("{}; best elsewhere 5.0e-6", kStar));
}

SceneRequest Named(const std::string& name, std::vector<std::string> settings = {}) {
  SceneRequest request;
  request.scene = name;
  request.settings = std::move(settings);
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
                       AccurateStar({"method.smoothing_length=0.092"}), &StarOfEqualMasses},
      VerificationCase{"graded-star", "static star, hexagonal start, masses graded with density", false,
                       AccurateStar({"method.kernel=wendland-c4", "method.smoothing_length=0.0825",
                                     "fluid.arrange=hexagonal", "fluid.masses=graded", "fluid.flow=star"}),
                       &StarOfGradedMasses},
      VerificationCase{"breathing-star", "ten periods of a star that swells and shrinks", false,
                       Named("breathing-star"), &MeasureBreathingStar},
      VerificationCase{"taylor-green", "decaying vortices, Re = 100, 50 x 50", false, Named("taylor-green"),
                       &MeasureTaylorGreen},
      VerificationCase{"elliptic-drop", "a drop that becomes an ellipse, R/dx = 40", false, Named("elliptic-drop"),
                       &MeasureEllipticDrop},
      VerificationCase{"still-water", "a tank at rest, H/dx = 45", false, Named("still-water"), &MeasureStillWater},
      VerificationCase{"poiseuille", "flow between plates from start-up on, 60 across", true, Named("poiseuille"),
                       &MeasurePoiseuille},
      VerificationCase{"water-column", "front of a breaking column a x 2a, 10 000 particles", true,
                       Named("water-column"), &MeasureWaterColumn},
      VerificationCase{"oscillating-drop", "a drop under a central force, three periods, R/dx = 50", true,
                       Named("oscillating-drop"), &MeasureOscillatingDrop},
      VerificationCase{"rotating-square", "a square that throws out arms, L/dx = 100", true, Named("rotating-square"),
                       &MeasureRotatingSquare},
  };
  return cases;
}

void AdvanceTo(ParticleSystemSPH& system, double time) {
  constexpr double kRoundOff = 1e-6;  // of a step
  while (system.Time() < time - kRoundOff * system.parameters.time_step && !system.Trouble()) system.Step();
}

Vec2 SecondMoments(const Particles& particles) {
  Vec2 sum;
  for (std::size_t i = 0; i < particles.Size(); ++i) {
    sum = sum + particles.mass[i] * Vec2{particles.x[i] * particles.x[i], particles.y[i] * particles.y[i]};
  }
  return sum;
}

}  // namespace sph
