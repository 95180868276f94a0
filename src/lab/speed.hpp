// What a particle and step costs: run time against number of particles, threads, precision and instruction set, with
// its error.
#pragma once

#include <string>
#include <vector>

#include "lab/plot.hpp"
#include "scenes/scene.hpp"

namespace sph {

/// One run to be measured.
struct SpeedCase {
  std::size_t particles = 0;
  int threads = 1;
  Precision precision = Precision::kFloat;
  std::string instruction_set;
  bool keep_lists = true;  ///< with a skin around the lists; else they are made anew at every step
};

/// What it took, after a warm-up, and how far its last fields are from the same sums in scalar double precision.
struct SpeedResult {
  SpeedCase of;
  long steps = 0;  ///< in each repetition
  int repetitions = 0;
  double least_ns =
      0;  ///< wall time per particle and step of the fastest repetition, of the median one, of the slowest
  double median_ns = 0;
  double greatest_ns = 0;
  double grid_ns = 0;  ///< by phase, in the fastest repetition
  double density_ns = 0;
  double pressure_ns = 0;
  double walls_ns = 0;
  double integrate_ns = 0;
  double neighbours = 0;          ///< mean
  double bytes = 0;               ///< per particle
  double density_error = 0;       ///< greatest difference over greatest density, of about a thousand particles
  double acceleration_error = 0;  ///< the same of the accelerations
};

/// A box of water over a floor and between two walls, h = 1.3 spacings, about 20 neighbours in the support of 2h, that
/// sloshes a little: N particles on a jittered lattice.
Scene SpeedScene(const SpeedCase& of);

/// Runs that scene.
SpeedResult MeasureSpeed(const SpeedCase& of);

/// The cases of the whole benchmark, or of a short one.
std::vector<SpeedCase> SpeedCases(bool quick);

/// The results as CSV; the first line has the column names with units.
std::string SpeedAsCsv(const std::vector<SpeedResult>& results);

/// Million particle-steps per second against N, a curve for each precision, instruction set and number of threads.
Plot SpeedPlot(const std::vector<SpeedResult>& results);

}  // namespace sph
