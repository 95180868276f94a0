// What leaving out saves: runs with and without what a scene may not need, in turns, with their errors beside the
// times.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/speed.hpp"

namespace sph {

/// The usual unit.
constexpr const char* kNsOfAStep = "ns per particle and step";

/// One of the two runs of a comparison.
struct Arm {
  std::string what;
  std::function<double()> run;    ///< one repetition; its time in the comparison's unit
  std::function<double()> error;  ///< after the last repetition
};

struct Comparison {
  std::string mechanism;
  std::string unit;   ///< of the times
  Arm with;           ///< does the work
  Arm without;        ///< leaves it out
  std::string error;  ///< what the arms' error is
};

struct SkipResult {
  std::string mechanism;
  std::string unit;
  std::string what_with;
  std::string what_without;
  int repetitions = 0;
  Spread with;
  Spread without;
  std::string error;
  double error_with = 0;
  double error_without = 0;

  double Ratio() const { return with.least / without.least; }  ///< how many times faster without
};

/// Runs both arms in turns.
SkipResult Measure(const Comparison& comparison, int repetitions);

/// The comparisons in their order; each makes its systems when it is called. Float, one thread, the best instruction
/// set; in tanks of n particles, those of walls in tanks of n/10, and the time step's in the dam break.
std::vector<std::function<Comparison()>> SkipComparisons(std::size_t n);

}  // namespace sph
