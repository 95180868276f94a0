// How fast threads multiply and add on vectors, measured, and what the passes over neighbours could at best cost.
#pragma once

#include <map>

#include "sph/particle_system_sph.hpp"

namespace sph {

/// Multiply-adds [1/s] of so many threads together with the instruction set in use, each lane counted: the best of a
/// few tries with independent sums that stay in registers. Two threads that share a core make hardly more than one.
template <typename Real>
double MultiplyAddRate(int threads);

/// The same in both precisions with the best instruction set.
struct VectorRates {
  double in_float = 0;
  double in_double = 0;

  double Of(Precision precision) const { return precision == Precision::kFloat ? in_float : in_double; }
};
using RatesOfThreads = std::map<int, VectorRates>;
/// Of one thread and of two.
RatesOfThreads MeasureVectorRates();

/// Arithmetic operations on vectors that one vector of neighbours needs, counted from the passes and kernels on vectors
/// in src/sph. A fused multiply-add is one; broadcasting what belongs to neighbour j is a load and is not counted.
///
///                                                            float  double
///     x_i - x_j, y_i - y_j; float converts them from fixed point  4       2
///     r^2                                                         2       2
///     1/sqrt(r^2): estimate and Newton steps                      4      10
///     density:  o, i, both cut off at 0, o^3 - 4 i^3, the sum     8       8
///     pressure: o, i, both cut off at 0, (o^2 - 4 i^2)/r          8       8
///               T_i + T_j, their product, the two sums            4       4
struct PassOperations {
  int density = 0;
  int pressure = 0;
};
constexpr PassOperations OperationsPerVector(Precision precision) {
  if (precision == Precision::kFloat) return {4 + 2 + 4 + 8, 4 + 2 + 4 + 8 + 4};
  return {2 + 2 + 10 + 8, 2 + 2 + 10 + 8 + 4};
}

/// The limit of the run time of a particle and step [s]: its `neighbours` in the support only, no lane wasted on other
/// particles, every operation at the rate of multiply-adds, and all else free.
double LeastSeconds(const VectorRates& rates, Precision precision, double neighbours);

}  // namespace sph
