#include "lab/speed.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/instruction_set.hpp"
#include "scenes/build.hpp"

namespace sph {
namespace {

/// More where they are short.
int RepetitionsOf(const SpeedCase& of) { return of.flow == Flow::kTank && of.particles <= 100'000 ? 9 : 5; }

/// As long as it lives another instruction set is in use.
class InstructionSetFor {
 public:
  explicit InstructionSetFor(const std::string& name) : before_(InstructionSetInUse()) {
    UseInstructionSet(name, "bench");
  }
  ~InstructionSetFor() { UseInstructionSet(before_, "bench"); }
  InstructionSetFor(const InstructionSetFor&) = delete;
  InstructionSetFor& operator=(const InstructionSetFor&) = delete;

 private:
  std::string before_;
};

void CheckThatItRuns(const ParticleSystemSPH& system) {
  if (system.Trouble()) throw TroubleError("bench: the flow broke down: {}", system.Trouble()->Message());
}

/// The repetitions with one number of threads.
struct Measurement {
  std::vector<double> seconds = {};  // of a particle and step, in each repetition
  long steps = 0;
  std::map<std::string, double, std::less<>> phases = {};  // [s], of the fastest repetition, of a particle and step
};

/// At least `steps` steps, and on until lists were just made. Returns how many.
long StepToNewLists(ParticleSystemSPH& system, long steps) {
  constexpr long kMostMore = 50;
  long done = 0;
  for (bool made = false; done < steps || (!made && done < steps + kMostMore); ++done) {
    const long lists = system.Neighbours().ListsMade();
    system.Step();
    made = system.Neighbours().ListsMade() != lists;
  }
  return done;
}

/// Whole lives of lists, at least `steps` steps. One more goes before them: another number of threads has other caches.
void Repeat(ParticleSystemSPH& system, long steps, Measurement& measurement) {
  StepToNewLists(system, 1);
  const auto before = system.Phases().Seconds();
  const Stopwatch watch;
  const long done = StepToNewLists(system, steps);
  const double particle_steps = static_cast<double>(done) * static_cast<double>(system.State().Size());
  const double seconds = watch.Seconds() / particle_steps;
  measurement.steps += done;
  measurement.seconds.push_back(seconds);
  if (seconds > *std::min_element(measurement.seconds.begin(), measurement.seconds.end())) return;
  for (const auto& [phase, total] : system.Phases().Seconds()) {
    const auto then = before.find(phase);
    measurement.phases[phase] = (total - (then == before.end() ? 0 : then->second)) / particle_steps;
  }
}

/// At least one life of the lists. The column's repetitions share half a time
/// scale.
long StepsOfARepetition(const ParticleSystemSPH& system, const SpeedCase& of) {
  constexpr long kFewest = 8;
  const double n = static_cast<double>(system.State().Size());
  const double tank = of.particle_steps / n;
  const double column = 0.5 * TimeScale() / system.parameters.time_step / RepetitionsOf(of);
  const double steps = of.flow == Flow::kTank ? tank : column / static_cast<double>(of.threads.size());
  return std::max(kFewest, std::lround(steps));
}

}  // namespace

Spread SpreadOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2], times.back()};
}

void WarmUp(ParticleSystemSPH& system, Flow flow) {
  const Parameters wanted = system.parameters;
  system.parameters.threads = 0;
  if (flow == Flow::kCollapse) {
    while (system.Time() < TimeScale() && !system.Trouble()) system.Step();
  } else {
    // A summed density is too small at walls and surface, which pull the outer layers together with a fifth of the
    // speed of sound. Damped within ten steps, 4 h/c, that is over after sixty, whatever N is.
    constexpr int kSteps = 60;
    system.parameters.motion_damping = 0.1 / system.parameters.time_step;
    for (int step = 0; step < kSteps; ++step) system.Step();
  }
  system.parameters = wanted;
  CheckThatItRuns(system);
}

std::vector<SpeedResult> MeasureSpeed(const SpeedCase& of, const RatesOfThreads& rates) {
  const InstructionSetFor set(of.instruction_set);
  const auto system = MakeSystem(SpeedScene(of.flow, of.particles, of.precision));
  WarmUp(*system, of.flow);
  const long steps = StepsOfARepetition(*system, of);
  const long lists_before = system->Neighbours().ListsMade();
  const long steps_before = system->Steps();
  std::vector<Measurement> measurements(of.threads.size());
  for (int repetition = 0; repetition < RepetitionsOf(of); ++repetition) {
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      system->parameters.threads = of.threads[k];
      Repeat(*system, steps, measurements[k]);
    }
  }
  CheckThatItRuns(*system);
  SpeedResult common;
  common.flow = of.flow;
  common.particles = system->State().Size();
  common.precision = of.precision;
  common.instruction_set = InstructionSetInUse();
  common.repetitions = RepetitionsOf(of);
  common.steps_per_list = static_cast<double>(system->Steps() - steps_before) /
                          static_cast<double>(std::max(1L, system->Neighbours().ListsMade() - lists_before));
  common.bytes = static_cast<double>(system->Bytes()) / static_cast<double>(common.particles);
  system->ComputeFields();
  common.neighbours = system->MeanNeighbours();
  common.errors = ErrorsAgainstScalarTwin(*system);
  std::vector<SpeedResult> results;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    Measurement& measured = measurements[k];
    SpeedResult& result = results.emplace_back(common);
    result.threads = of.threads[k];
    result.steps = measured.steps;
    for (double& seconds : measured.seconds) seconds *= 1e9;
    result.ns = SpreadOf(measured.seconds);
    result.grid_ns = 1e9 * measured.phases["grid"];
    result.density_ns = 1e9 * measured.phases["density"];
    result.pressure_ns = 1e9 * measured.phases["pressure"];
    result.walls_ns = 1e9 * measured.phases["walls"];
    result.integrate_ns = 1e9 * measured.phases["integrate"];
    result.limit_ns = 1e9 * LeastSeconds(rates.at(result.threads), of.precision, common.neighbours);
  }
  return results;
}

std::vector<SpeedCase> SpeedCases(bool quick) {
  const std::vector<std::size_t> tanks = quick ? std::vector<std::size_t>{1000, 10'000}
                                               : std::vector<std::size_t>{1000, 10'000, 100'000, 1'000'000, 4'000'000};
  const std::vector<std::size_t> columns =
      quick ? std::vector<std::size_t>{10'000} : std::vector<std::size_t>{10'000, 100'000};
  std::vector<SpeedCase> cases;
  for (const Precision precision : {Precision::kFloat, Precision::kDouble}) {
    for (const std::string& set : AvailableInstructionSets()) {
      for (const std::size_t n : tanks) cases.push_back({Flow::kTank, n, precision, set});
    }
    for (const std::size_t n : columns) {
      cases.push_back({Flow::kCollapse, n, precision, AvailableInstructionSets().back()});
    }
  }
  return cases;
}

}  // namespace sph
