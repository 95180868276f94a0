// What a run is held to, as checks of one number after the other: energy, volume, rest. Each keeps the first flaw that
// it finds.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sph {

/// Energy may turn from one kind into another and be lost; more than what is put in it may not grow. As leapfrog's own
/// energy is the true one but for a swing with every wave of sound, means of some looks are compared, the mean of now
/// with the least before.
class EnergyBudget {
 public:
  /// Looks whose mean is compared.
  static constexpr int kWindow = 10;
  /// Growth over the greatest energy that could become motion so far: what the methods leave at these few particles.
  static constexpr double kMostGrowth = 0.05;

  /// @param still   energy that makes no difference [J/m]
  /// @param mass    of the fluid [kg/m], and
  /// @param slide   the greatest speed of a wall that drags it along [m/s]
  EnergyBudget(double still, double mass, double slide) : still_(still), mass_(mass), slide_(slide) {}

  /// A look: kinetic energy, what is stored in pressure, walls and forces, and what was put in since the start [J/m].
  void Add(double kinetic, double stored, double put_in);
  const std::string& Flaw() const { return flaw_; }

 private:
  double Allowance() const;

  double still_, mass_, slide_;
  int looks_ = 0;
  double sum_ = 0;
  std::optional<double> least_;  // of the means
  double highest_ = -std::numeric_limits<double>::infinity(), lowest_stored_ = -highest_;
  std::string flaw_;
};

/// A liquid's volume, by its densities (sum of m/rho) and by the places that its particles fill.
class VolumeCheck {
 public:
  static constexpr double kMostDrift = 0.05;
  static constexpr int kLooksInARow = 3;  ///< of areas: a gap seems filled just before it closes

  /// @param nominal  M/rho0 [m^2]
  explicit VolumeCheck(double nominal) : nominal_(nominal) {}

  /// @param unsure  of what they fill [m^2]: an edge of particles is ragged
  /// What particles fill is compared with what they filled at first and with the nominal volume, whichever is further
  /// away: random particles leave holes at first, which close.
  void Add(double by_density, std::optional<double> by_place, double unsure = 0);
  const std::string& Flaw() const { return flaw_; }

 private:
  double nominal_;
  std::optional<double> first_;
  int out_of_range_ = 0;  // looks in a row
  std::string flaw_;
};

/// A fluid that starts in balance comes to rest, or stays there: the mean kinetic energy of the last quarter of a run
/// is not above that of the quarter before.
class RestCheck {
 public:
  static constexpr double kMostGrowth = 1.25;  ///< what swings need not have the same mean in both quarters

  /// @param still  kinetic energy that makes no difference [J/m]
  explicit RestCheck(double still) : still_(still) {}

  void Add(double kinetic) { kinetic_.push_back(kinetic); }
  /// At the end of the run.
  std::string Flaw() const;

 private:
  double still_;
  std::vector<double> kinetic_;
};

}  // namespace sph
