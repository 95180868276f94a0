// Verification: runs of scenes with exact solutions, what came out, and the bar that it is held against.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "scenes/request.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// One metric of one run. It holds if 0 <= value <= bar.
struct Verdict {
  std::string metric;  ///< with its unit, or relative
  double value = 0;
  double bar = 0;
  std::string reference;  ///< what is exact, and what others reach

  bool Holds() const { return value >= 0 && value <= bar; }
};

struct VerificationCase {
  std::string name;
  std::string what;   ///< one line for people
  bool slow = false;  ///< left out unless asked for
  SceneRequest request;
  /// Advances the system of that scene and measures. A run that breaks down has verdicts that do not hold.
  std::vector<Verdict> (*measure)(ParticleSystemSPH& system);
};

/// Every case, in the order in which they are shown.
std::span<const VerificationCase> AllVerificationCases();

// The cases, one file each.
std::vector<Verdict> MeasureStaticStar(ParticleSystemSPH& system, double bar, const std::string& reference);
std::vector<Verdict> MeasureBreathingStar(ParticleSystemSPH& system);
std::vector<Verdict> MeasureTaylorGreen(ParticleSystemSPH& system);
std::vector<Verdict> MeasureEllipticDrop(ParticleSystemSPH& system);
std::vector<Verdict> MeasureStillWater(ParticleSystemSPH& system);
std::vector<Verdict> MeasureWaterColumn(ParticleSystemSPH& system);
std::vector<Verdict> MeasurePoiseuille(ParticleSystemSPH& system);
std::vector<Verdict> MeasureOscillatingDrop(ParticleSystemSPH& system);
std::vector<Verdict> MeasureRotatingSquare(ParticleSystemSPH& system);

/// The value of a metric of a run that broke down: no bar holds it.
inline constexpr double kBroken = std::numeric_limits<double>::infinity();

/// Steps until `time` [s] or until the run breaks down.
void AdvanceTo(ParticleSystemSPH& system, double time);

/// Sum of m x^2 and of m y^2 over the particles [kg m].
Vec2 SecondMoments(const Particles& particles);

}  // namespace sph
