// Numerical stability put to the test: each test a row of one table, what it found rows with a bar, plots and tables.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/plot.hpp"
#include "sph/particle_system_sph.hpp"

namespace sph {

/// One finding. It holds if 0 <= value <= bar.
struct StressRow {
  std::string what;    ///< of which scene, solver, treatment
  std::string metric;  ///< what the value is, with its unit
  double value = 0;
  double bar = 0;
  std::string note = {};  ///< what is behind the value: a limit, a seed to repeat it with

  bool Holds() const { return value >= 0 && value <= bar && std::isfinite(value); }
};

struct StressOptions {
  bool quick = false;  ///< small systems and short runs
  int threads = 0;     ///< 0: as many as there are processors
  /// Of the first start or scene; the others follow. Default: 1, and for random scenes one of the day.
  std::optional<std::uint64_t> seed;
  std::optional<long> count;  ///< of starts or scenes; default: the test's own

  std::uint64_t FirstSeed() const { return seed.value_or(1); }
  long CountOr(long full, long small) const { return count.value_or(quick ? small : full); }
};

/// Where a test puts what it finds, as soon as it is found.
class StressSink {
 public:
  virtual ~StressSink() = default;
  virtual void Row(const StressRow& row) = 0;
  /// A plot, and the numbers behind it, for files of that name.
  virtual void Figure(const std::string& name, const Plot& plot, const std::string& csv) = 0;
  /// What is about to be tried, for who wants to know where the program was when it crashed, or did not come to an end
  /// within so many seconds (0: as long as it takes).
  virtual void Note(const std::string& text, unsigned patience_s = 0) = 0;
  /// Something that somebody asked for beside the findings.
  virtual void Say(const std::string& text) = 0;
  /// Whether to end here.
  virtual bool Stopped() const = 0;
};

struct StressTest {
  std::string name;
  std::string what;  ///< one line for people
  void (*run)(const StressOptions& options, StressSink& sink);
};

/// Every test, in the order in which they are run.
std::span<const StressTest> AllStressTests();

// The tests, one file each.
void StressStepLimit(const StressOptions& options, StressSink& sink);
void StressStarts(const StressOptions& options, StressSink& sink);
void StressSize(const StressOptions& options, StressSink& sink);
void StressLength(const StressOptions& options, StressSink& sink);
void StressRough(const StressOptions& options, StressSink& sink);
void StressRandom(const StressOptions& options, StressSink& sink);

/// The bar of what is only shown.
inline constexpr double kNoBar = std::numeric_limits<double>::infinity();

/// The value of a run that broke down: no bar holds it.
inline constexpr double kNoValue = std::numeric_limits<double>::infinity();

/// The greatest value for which `holds` says so, up to a factor 1 + `accuracy`: `holds(low)` is taken for granted,
/// `high` is doubled until it does not hold; kNoValue if it always does.
double GreatestThatHolds(double low, double high, double accuracy, const std::function<bool(double)>& holds);

/// The first of the random scenes of a day: the day as a number, with room for a hundred thousand behind it.
std::uint64_t SeedOfDay(std::chrono::sys_days day);

/// The first thing of a system that a program may not print: a number that is none, an index that is twice there.
/// Empty if all is in order.
std::string FirstFlaw(const ParticleSystemSPH& system);

}  // namespace sph
