// Verification: runs of scenes with exact solutions, what came out, and the bar that it is held against.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenes/request.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// An error as a part of the quantity's own scale.
struct RelativeError {
  std::string metric;
  double value = 0;
};

/// One metric of one run. It holds if 0 <= value <= bar.
struct Verdict {
  std::string metric;  ///< with its unit, or relative
  double value = 0;
  double bar = 0;
  std::string reference;                       ///< what is exact, and what others reach
  std::optional<RelativeError> relative = {};  ///< the same, where `value` has a unit
  bool is_error = true;                        ///< false: a run time

  bool Holds() const { return value >= 0 && value <= bar; }
};

/// What is known of a flow at one time.
struct FlowSnapshot {
  double time = 0;  ///< [s]
  Particles particles = {};
  std::vector<double> pressure = {};  ///< [Pa], as many as particles
};

/// How a case judges a run, this program's or another's, from what it looked like at some times.
struct Judgement {
  /// The times to look at [s], ascending.
  std::vector<double> (*times)(const ParticleSystemSPH& flow);
  /// Snapshots at about these times, of a flow whose parameters are those of `flow`; none if it broke down: then no
  /// verdict holds.
  std::vector<Verdict> (*judge)(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots);
};

struct VerificationCase {
  std::string name;
  std::string what;   ///< one line for people
  bool slow = false;  ///< left out unless asked for
  SceneRequest request;
  /// Advances the system of that scene and measures. A run that breaks down has verdicts that do not hold.
  std::vector<Verdict> (*measure)(ParticleSystemSPH& system);
  const Judgement* judgement = nullptr;  ///< of `measure`, where others' runs of the same flow can be judged, too
  bool in_bench = true;                  ///< false where `measure` is not of one run that has errors at any resolution
};

/// Every case, in the order in which they are shown.
std::span<const VerificationCase> AllVerificationCases();

// The cases, one file each.
std::vector<Verdict> MeasureStaticStar(ParticleSystemSPH& system, double bar, const std::string& reference);
std::vector<Verdict> MeasureBreathingStar(ParticleSystemSPH& system);
std::vector<Verdict> MeasureEllipticStar(ParticleSystemSPH& system);
std::vector<Verdict> MeasureTaylorGreen(ParticleSystemSPH& system);
std::vector<Verdict> MeasureTaylorGreenOrder(ParticleSystemSPH& system);
std::vector<Verdict> MeasureEllipticDrop(ParticleSystemSPH& system);
std::vector<Verdict> MeasureStillWater(ParticleSystemSPH& system);
std::vector<Verdict> MeasureWaterColumn(ParticleSystemSPH& system);
std::vector<Verdict> MeasurePoiseuille(ParticleSystemSPH& system);
std::vector<Verdict> MeasureMeasuredFront(ParticleSystemSPH& system);
std::vector<Verdict> MeasureCouette(ParticleSystemSPH& system);
std::vector<Verdict> MeasureOscillatingDrop(ParticleSystemSPH& system);
std::vector<Verdict> MeasureCapillaryDrop(ParticleSystemSPH& system);
std::vector<Verdict> MeasureRotatingSquare(ParticleSystemSPH& system);
std::vector<Verdict> MeasureStandingWave(ParticleSystemSPH& system);
std::vector<Verdict> MeasureWallArrival(ParticleSystemSPH& system);
std::vector<Verdict> MeasureWallImpact(ParticleSystemSPH& system);
std::vector<Verdict> MeasureWallPressure(ParticleSystemSPH& system);
std::vector<Verdict> MeasureOperators(ParticleSystemSPH& system);
std::vector<Verdict> MeasureMomentum(ParticleSystemSPH& system);
std::vector<Verdict> MeasureReversal(ParticleSystemSPH& system);

/// The scene of MeasureOperators: vortices so arranged, with this viscosity [Pa s], and a step in which nothing moves.
SceneRequest FrozenVortices(const std::string& arrange, std::size_t particles, const std::string& viscosity);

/// The value of a metric of a run that broke down: no bar holds it.
inline constexpr double kBroken = std::numeric_limits<double>::infinity();

extern const Judgement kTaylorGreen, kEllipticDrop, kStillWater, kPoiseuille, kWaterColumn;

/// Steps until `time` [s] or until the run breaks down.
void AdvanceTo(ParticleSystemSPH& system, double time);

/// Advances the system to the times of a judgement, and judges it.
std::vector<Verdict> Judge(const Judgement& judgement, ParticleSystemSPH& system);

/// The root of a mean square error of density [kg^2/m^6] over the density in the centre of the static star.
double StarErrorOf(double mse);

/// Sum of m x^2 and of m y^2 over the particles [kg m].
Vec2 SecondMoments(const Particles& particles);

}  // namespace sph
