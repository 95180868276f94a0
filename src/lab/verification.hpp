// Verification: runs of scenes with exact solutions, what came out, and the bar that it is held against.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/verdict.hpp"
#include "scenes/request.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

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
  /// What settings cannot say of the scene.
  void (*change)(Scene& scene) = nullptr;
  /// The numbers of particles of the ladder, over the case's own, from coarse to fine; at least two up to 1.
  std::vector<double> shares = {0.25, 1, 4};
};

/// Every case, in the order in which they are shown.
std::span<const VerificationCase> AllVerificationCases();

// The cases, one file each.
std::vector<Verdict> MeasureStaticStar(ParticleSystemSPH& system, double bar, const std::string& reference);
std::vector<Verdict> MeasureBreathingStar(ParticleSystemSPH& system);
std::vector<Verdict> MeasureEllipticStar(ParticleSystemSPH& system);
std::vector<Verdict> MeasureTaylorGreen(ParticleSystemSPH& system);
std::vector<Verdict> MeasureShearWave(ParticleSystemSPH& system);
std::vector<Verdict> MeasureEllipticDrop(ParticleSystemSPH& system);
std::vector<Verdict> MeasureStillWater(ParticleSystemSPH& system);
std::vector<Verdict> MeasureTankOfParticles(ParticleSystemSPH& system);
std::vector<Verdict> MeasureRest(ParticleSystemSPH& system);
std::vector<Verdict> MeasureTiltedRest(ParticleSystemSPH& system);
std::vector<Verdict> MeasurePoiseuille(ParticleSystemSPH& system);
std::vector<Verdict> MeasureDisorderedPoiseuille(ParticleSystemSPH& system);
std::vector<Verdict> MeasureSteadyPoiseuille(ParticleSystemSPH& system);
std::vector<Verdict> MeasureCouette(ParticleSystemSPH& system);
std::vector<Verdict> MeasureDisorderedCouette(ParticleSystemSPH& system);
std::vector<Verdict> MeasureCavity(ParticleSystemSPH& system);
std::vector<Verdict> MeasureCavityDrift(ParticleSystemSPH& system);
std::vector<Verdict> MeasureWaterColumn(ParticleSystemSPH& system);
std::vector<Verdict> MeasureColumnNoise(ParticleSystemSPH& system);
std::vector<Verdict> MeasureFrontConvergence(ParticleSystemSPH& system);
std::vector<Verdict> MeasureMeasuredFront(ParticleSystemSPH& system);
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

// What their scenes have that settings cannot say.
/// A step in which nothing moves, and only the forces that are asked for.
void Freeze(Scene& scene);
/// A ceiling, so that gravity may be tilted.
void CloseTank(Scene& scene);

extern const Judgement kTaylorGreen, kEllipticDrop, kStillWater, kPoiseuille, kWaterColumn, kCavity;

/// Steps until `time` [s] or until the run breaks down.
void AdvanceTo(ParticleSystemSPH& system, double time);

/// Advances the system to the times of a judgement, and judges it.
std::vector<Verdict> Judge(const Judgement& judgement, ParticleSystemSPH& system);

/// The root of a mean square error of density [kg^2/m^6] over the density in the centre of the static star.
double StarErrorOf(double mse);

/// Sum of m x^2 and of m y^2 over the particles [kg m].
Vec2 SecondMoments(const Particles& particles);

}  // namespace sph
