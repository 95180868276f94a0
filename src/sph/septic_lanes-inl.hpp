// The weights of the viscous force on vectors: included once for each instruction set.
#if defined(SPH_SEPTIC_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SPH_SEPTIC_LANES_INL_HPP
#undef SPH_SEPTIC_LANES_INL_HPP
#else
#define SPH_SEPTIC_LANES_INL_HPP
#endif

#include <hwy/highway.h>

#include <numbers>

#include "sph/kernel_lanes-inl.hpp"
#include "sph/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {

/// SepticSpline's -W'/r (kFlat - kFall s^2), s = r/R: with q = 4s, ((4-q)^6 - 8 (3-q)^6 + 28 (2-q)^6 - 56 (1-q)^6)/q,
/// each power only where its base is positive, times the bracket.
template <class D>
class SepticLaplacianLanes {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  /// @param support  in the coordinates' unit
  SepticLaplacianLanes(D d, T support)
      : d_(d),
        per_h_(4 / support),
        flat_(hn::Set(d, static_cast<T>(SepticSpline::kFlat))),
        fall_(hn::Set(d, static_cast<T>(SepticSpline::kFall) / (support * support))) {}

  /// By what the lanes become [1/m^4]; support in metres.
  static double Factor(double support) {
    const double h = support / SepticSpline::kSupport;
    return 7 * SepticSpline::kNormalisation / (h * h * h * h);
  }

  HWY_INLINE V Of(V r2) const {
    const Distance<D> q(d_, r2, per_h_);
    const V outer = q.SubtractedFrom(Set(4));
    V sum = SixthPower(outer);
    sum = hn::NegMulAdd(SixthPower(hn::Sub(outer, Set(1))), Set(8), sum);
    sum = hn::MulAdd(SixthPower(hn::Sub(outer, Set(2))), Set(28), sum);
    sum = hn::NegMulAdd(SixthPower(hn::Sub(outer, Set(3))), Set(56), sum);
    // The sum is in proportion to q near 0, where its round-off would count.
    const V per_q = hn::Min(hn::Mul(q.Inverse(), hn::Set(d_, 1 / (per_h_ * per_h_))), Set(64));
    return hn::Mul(hn::Mul(sum, per_q), hn::NegMulAdd(r2, fall_, flat_));
  }

 private:
  HWY_INLINE V Set(double value) const { return hn::Set(d_, static_cast<T>(value)); }
  HWY_INLINE V SixthPower(V base) const {
    const V positive = hn::Max(base, hn::Zero(d_));
    const V square = hn::Mul(positive, positive);
    return hn::Mul(hn::Mul(square, square), square);
  }

  D d_;
  T per_h_;
  V flat_, fall_;
};

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
