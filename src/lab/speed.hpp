// What a particle and step costs: run time against number of particles, threads, precision and instruction set, with
// its error.
#pragma once

#include <string>
#include <vector>

#include "lab/scalar_twin.hpp"
#include "lab/speed_flows.hpp"
#include "lab/vector_rate.hpp"

namespace sph {

/// A flow to be measured.
struct SpeedCase {
  Flow flow = Flow::kTank;
  std::size_t particles = 0;
  Precision precision = Precision::kFloat;
  std::string instruction_set = "best";
  std::vector<int> threads = {1, 2};  ///< their repetitions take turns, so that noise and flow are the same for all
  double particle_steps = 1e6;        ///< of a repetition of a tank, at least
};

/// Wall time of some repetitions.
struct Spread {
  double least = 0;
  double median = 0;
  double greatest = 0;
};
/// Precondition: at least one time.
Spread SpreadOf(std::vector<double> times);

/// What a particle and step took with one of the case's numbers of threads, and how far its last fields are from the
/// same sums in scalar double precision.
struct SpeedResult {
  Flow flow = Flow::kTank;
  std::size_t particles = 0;
  Precision precision = Precision::kFloat;
  std::string instruction_set;
  int threads = 1;
  int repetitions = 0;
  long steps = 0;      ///< in all repetitions
  Spread ns;           ///< wall time of a particle and step
  double grid_ns = 0;  ///< of that, by pass, in the fastest repetition: cells and neighbour lists
  double density_ns = 0;
  double pressure_ns = 0;  ///< and gravity
  double walls_ns = 0;
  double integrate_ns = 0;
  double limit_ns = 0;        ///< LeastSeconds with these neighbours and threads
  double neighbours = 0;      ///< within the support, mean
  double steps_per_list = 0;  ///< how long lists were kept, mean
  double bytes = 0;           ///< of a particle
  FieldErrors errors;
};

/// Runs a case, after a warm-up: a tank until it is nearly still, a column until t = sqrt(H/g), in mid-collapse.
/// TroubleError if it breaks down. `rates` has every number of threads of the case.
std::vector<SpeedResult> MeasureSpeed(const SpeedCase& of, const RatesOfThreads& rates);

/// The cases of the whole benchmark, or of a short one.
std::vector<SpeedCase> SpeedCases(bool quick);

/// Brings a new system of the flow to where it is measured, on all threads.
void WarmUp(ParticleSystemSPH& system, Flow flow);

}  // namespace sph
