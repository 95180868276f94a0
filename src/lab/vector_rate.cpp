// The rate of multiply-adds on vectors; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/vector_rate.cpp"
#include "lab/vector_rate.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <algorithm>

#include "base/check.hpp"
#include "base/clock.hpp"
#include "base/instruction_set.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// kSums sums. @return something of the sums, so that no compiler leaves them out.
template <typename Real>
Real MultiplyAdds(long rounds) {
  const hn::ScalableTag<Real> d;
  const auto factor = hn::Set(d, static_cast<Real>(0.75));  // the sums tend to 1
  const auto term = hn::Set(d, static_cast<Real>(0.25));
  auto a = hn::Iota(d, Real(0)), b = a, c = a, e = a, f = a, g = a, h = a, k = a, l = a, m = a;
  for (long round = 0; round < rounds; ++round) {
    a = hn::MulAdd(a, factor, term);
    b = hn::MulAdd(b, factor, term);
    c = hn::MulAdd(c, factor, term);
    e = hn::MulAdd(e, factor, term);
    f = hn::MulAdd(f, factor, term);
    g = hn::MulAdd(g, factor, term);
    h = hn::MulAdd(h, factor, term);
    k = hn::MulAdd(k, factor, term);
    l = hn::MulAdd(l, factor, term);
    m = hn::MulAdd(m, factor, term);
  }
  for (const auto sum : {b, c, e, f, g, h, k, l, m}) a = hn::Add(a, sum);
  return hn::GetLane(a);
}

}  // namespace

float MultiplyAddsFloat(long rounds) { return MultiplyAdds<float>(rounds); }
double MultiplyAddsDouble(long rounds) { return MultiplyAdds<double>(rounds); }

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sph {
namespace {

HWY_EXPORT(MultiplyAddsFloat);
HWY_EXPORT(MultiplyAddsDouble);

float Run(long rounds, float) { return HWY_DYNAMIC_DISPATCH(MultiplyAddsFloat)(rounds); }
double Run(long rounds, double) { return HWY_DYNAMIC_DISPATCH(MultiplyAddsDouble)(rounds); }

}  // namespace

/// Sums that do not wait for each other: more than two units with a latency of four cycles can work on; with both
/// factors they fit in the sixteen registers of the smallest set.
constexpr int kSums = 10;

template <typename Real>
double MultiplyAddRate(int threads) {
  constexpr int kTries = 20;
  constexpr long kRounds = 1'000'000;  // some milliseconds
  double least = 1e9;
  Real sum = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const Stopwatch watch;
#pragma omp parallel for num_threads(threads) reduction(+ : sum) schedule(static, 1)
    for (int thread = 0; thread < threads; ++thread) sum += Run(kRounds, Real{});
    least = std::min(least, watch.Seconds());
  }
  SPH_CHECK(sum > 0, "sum = {}", sum);
  return threads * static_cast<double>(kRounds) * kSums * Lanes<Real>() / least;
}
template double MultiplyAddRate<float>(int);
template double MultiplyAddRate<double>(int);

RatesOfThreads MeasureVectorRates() {
  const std::string before = InstructionSetInUse();
  UseInstructionSet("best", "bench");
  RatesOfThreads rates;
  for (const int threads : {1, 2}) rates[threads] = {MultiplyAddRate<float>(threads), MultiplyAddRate<double>(threads)};
  UseInstructionSet(before, "bench");
  return rates;
}

double LeastSeconds(const VectorRates& rates, Precision precision, double neighbours) {
  const PassOperations operations = OperationsPerVector(precision);
  return neighbours * (operations.density + operations.pressure) / rates.Of(precision);
}

}  // namespace sph
#endif  // HWY_ONCE
