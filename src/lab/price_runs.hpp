// The price of accuracy: run time and error, from the same runs of a case, for every solver, step, precision and number
// of particles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/frontier.hpp"
#include "lab/price_methods.hpp"

namespace sph {

struct PriceOptions {
  double longest = 5;  ///< a run that would take longer is left out [s]
  bool quick = false;  ///< no more than an eighth of the case's own particles, each run once
  int threads = 1;
};

/// One run, or why there is none.
struct PricedRun {
  Method method;
  std::size_t particles = 0;
  long steps = 0;
  int repetitions = 0;
  double least = 0;     ///< [s] from the first step to the last measurement, the start left out: processor time of one
                        ///< thread, wall time of several
  double greatest = 0;  ///< [s]
  std::vector<double> errors = {};  ///< of ErrorsOf; empty if the run was left out
  std::string note = {};            ///< why it was left out, or how it broke down

  bool Held() const;  ///< did it run to its end?
};

/// "delta float adaptive"
std::string NameOf(const Method& method);

struct PricedCase {
  std::string name;
  std::string what;
  std::size_t own_particles = 0;          ///< with which verify runs it
  std::vector<std::string> metrics = {};  ///< of ErrorsOf
  std::vector<PricedRun> runs = {};       ///< method by method, each from coarse to fine
  int threads = 1;
};

/// The relative errors among the verdicts; if there are several, after the greatest of them: a run that has one thing
/// right by chance, and another wrong, is wrong.
std::vector<double> ErrorsOf(const std::vector<Verdict>& verdicts);

/// One run, repeated if it is short. `metrics` become those of ErrorsOf if it held and they were empty.
PricedRun MeasureRun(const VerificationCase& of, const PriceOptions& options, const Method& method,
                     std::size_t particles, std::vector<std::string>& metrics);

/// Runs a case by every method, from coarse to fine until a run would take too long or errors fall no more (three runs
/// of the first metric without a better one); short ones repeatedly. Ends early when `interrupted` says so.
PricedCase MeasurePrices(const VerificationCase& of, const PriceOptions& options,
                         const std::function<bool()>& interrupted);

/// Time and error, in one metric, of the runs that `wanted` accepts.
std::vector<Price> PricesOf(const PricedCase& of, std::size_t metric,
                            const std::function<bool(const PricedRun&)>& wanted);

}  // namespace sph
