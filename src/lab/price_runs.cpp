#include "lab/price_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/clock.hpp"
#include "scenes/build.hpp"
#include "sph/solvers.hpp"

namespace sph {
namespace {

constexpr int kMostRepetitions = 4;
constexpr double kEnough = 0.2;  // [s] in all repetitions

/// Time goes with the particles and the steps, these with 1/spacing.
double Expected(const PricedRun& coarser, std::size_t particles) {
  return coarser.least * std::pow(static_cast<double>(particles) / static_cast<double>(coarser.particles), 1.5);
}

/// Fills the run's errors, and the metrics if the run is the first with any.
void NoteErrors(const std::vector<Verdict>& verdicts, PricedRun& run, std::vector<std::string>& metrics) {
  run.errors = ErrorsOf(verdicts);
  const bool measured =
      !run.errors.empty() && std::ranges::all_of(run.errors, [](double error) { return std::isfinite(error); });
  if (!measured && run.note.empty()) {
    run.note = "went another way: nothing to measure";
  }
  if (!run.note.empty() || !metrics.empty()) return;
  for (const Verdict& verdict : verdicts) {
    if (verdict.kind != MetricKind::kPrice)
      metrics.push_back(verdict.relative ? verdict.relative->metric : verdict.metric);
  }
  if (metrics.size() > 1) metrics.insert(metrics.begin(), "greatest error");
}

/// One repetition; false if there is no such run.
bool RunOnce(const VerificationCase& of, const PriceOptions& options, PricedRun& run,
             std::vector<std::string>& metrics) {
  const Prepared prepared = Prepare(of, run.method, run.particles, options.threads);
  if (!prepared.system) {
    run.note = prepared.why_not;
    return false;
  }
  const Stopwatch wall;
  const ProcessorStopwatch processor;
  const std::vector<Verdict> verdicts = of.measure(*prepared.system);
  const double seconds = options.threads == 1 ? processor.Seconds() : wall.Seconds();
  run.least = run.repetitions == 0 ? seconds : std::min(run.least, seconds);
  run.greatest = std::max(run.greatest, seconds);
  ++run.repetitions;
  run.steps = prepared.system->Steps();
  if (prepared.system->Trouble()) run.note = "broke down: " + prepared.system->Trouble()->limit;
  NoteErrors(verdicts, run, metrics);
  return true;
}

/// A method, from coarse to fine: how long the next run would take, and whether finer runs still help.
class Ladder {
 public:
  void Add(const PricedRun& run) {
    if (run.repetitions == 0) return;
    last_ = run;
    if (run.Held() && run.errors.front() < kLeastGain * best_) {
      best_ = run.errors.front();
      in_vain_ = 0;
    } else if (std::isfinite(best_)) {
      ++in_vain_;
    }
  }
  /// Why not to run with that many particles; empty if nothing speaks against it. With as many as verify takes a run is
  /// made also where it does not help.
  std::string WhyNot(std::size_t particles, bool own, double longest) const {
    const double expected = last_ ? Expected(*last_, particles) : 0;
    if (expected > longest) return fmt::format("left out: would take about {:.2g} s", expected);
    return in_vain_ >= kPatience && !own ? "left out: errors fall no more" : "";
  }

 private:
  static constexpr double kLeastGain = 0.95;
  static constexpr int kPatience = 3;

  double best_ = kBroken;
  int in_vain_ = 0;                // runs since one was better than all before
  std::optional<PricedRun> last_;  // that was run
};

void MeasureMethod(const VerificationCase& of, const PriceOptions& options, const Method& method, PricedCase& into,
                   const std::function<bool()>& interrupted) {
  Ladder ladder;
  for (const std::size_t particles : Resolutions(of)) {
    if (interrupted() || (options.quick && particles > into.own_particles / 4)) return;
    const std::string why_not = ladder.WhyNot(particles, particles == into.own_particles, options.longest);
    if (!why_not.empty()) {
      into.runs.emplace_back();
      into.runs.back().method = method;
      into.runs.back().particles = particles;
      into.runs.back().note = why_not;
      continue;
    }
    into.runs.push_back(MeasureRun(of, options, method, particles, into.metrics));
    ladder.Add(into.runs.back());
  }
}

}  // namespace

std::vector<double> ErrorsOf(const std::vector<Verdict>& verdicts) {
  std::vector<double> errors;
  for (const Verdict& verdict : verdicts) {
    if (verdict.kind == MetricKind::kPrice) continue;
    errors.push_back(std::abs(verdict.relative ? verdict.relative->value : verdict.value));
  }
  if (errors.size() > 1) errors.insert(errors.begin(), std::ranges::max(errors));
  return errors;
}

bool PricedRun::Held() const { return repetitions > 0 && note.empty(); }

std::string NameOf(const Method& method) {
  return fmt::format("{} {} {}", method.solver, method.precision == Precision::kFloat ? "float" : "double",
                     NameOf(method.step));
}

PricedRun MeasureRun(const VerificationCase& of, const PriceOptions& options, const Method& method,
                     std::size_t particles, std::vector<std::string>& metrics) {
  PricedRun run;
  run.method = method;
  run.particles = particles;
  const int repetitions = options.quick ? 1 : kMostRepetitions;
  double spent = 0;
  do {
    if (!RunOnce(of, options, run, metrics)) return run;
    spent += run.greatest;
  } while (run.repetitions < repetitions && spent < kEnough && run.Held());
  return run;
}

PricedCase MeasurePrices(const VerificationCase& of, const PriceOptions& options,
                         const std::function<bool()>& interrupted) {
  PricedCase result{.name = of.name, .what = of.what, .threads = options.threads};
  result.own_particles = LoadScene(of.request).base.fluid.particles;
  for (const Solver& solver : AllSolvers()) {
    for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
      for (const StepChoice step : {StepChoice::kScene, StepChoice::kHalf, StepChoice::kAdaptive}) {
        MeasureMethod(of, options, {solver.name, step, precision}, result, interrupted);
      }
    }
  }
  return result;
}

std::vector<Price> PricesOf(const PricedCase& of, std::size_t metric,
                            const std::function<bool(const PricedRun&)>& wanted) {
  std::vector<Price> prices;
  for (const PricedRun& run : of.runs) {
    if (run.Held() && metric < run.errors.size() && wanted(run)) prices.push_back({run.least, run.errors[metric]});
  }
  return prices;
}

}  // namespace sph
