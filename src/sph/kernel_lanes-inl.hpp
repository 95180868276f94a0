// The kernels of kernels.hpp on vectors: included once for each instruction set. Lengths are in units of the
// coordinates; each kernel says by which factor its lanes become W [1/m^2] and -W'/r times a difference [1/m^3].
#if defined(SPH_KERNEL_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SPH_KERNEL_LANES_INL_HPP
#undef SPH_KERNEL_LANES_INL_HPP
#else
#define SPH_KERNEL_LANES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Distances r, and 1/r, of vectors with squared length r2 > 0, both times a factor that costs nothing, to full
/// precision: the processor's estimate of 1/sqrt(r2), of 12 bits or more, refined by one Newton step for float and by
/// two for double.
template <class D>
class Distance {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  HWY_INLINE Distance(D d, V r2, T factor = 1) {
#if HWY_ARCH_X86
    if constexpr (sizeof(T) == 4) {
      estimate_ = hn::ApproximateReciprocalSqrt(r2);
    } else {
      const hn::Rebind<float, D> df;
      const V rough = hn::PromoteTo(d, hn::ApproximateReciprocalSqrt(hn::DemoteTo(df, r2)));
      const V step = hn::NegMulAdd(hn::Mul(hn::Mul(r2, hn::Set(d, T(0.5))), rough), rough, hn::Set(d, T(1.5)));
      estimate_ = hn::Mul(rough, step);
    }
    length_ = hn::Mul(r2, estimate_);
    correction_ = hn::NegMulAdd(hn::Mul(length_, estimate_), hn::Set(d, T(0.5) * factor), hn::Set(d, T(1.5) * factor));
#else
    length_ = hn::Sqrt(r2);
    correction_ = hn::Set(d, factor);
    estimate_ = hn::Div(hn::Set(d, T(1)), length_);
#endif
  }

  /// from - factor r
  HWY_INLINE V SubtractedFrom(V from) const { return hn::NegMulAdd(length_, correction_, from); }
  /// factor/r
  HWY_INLINE V Inverse() const { return hn::Mul(estimate_, correction_); }

 private:
  V estimate_;  // of 1/r
  V length_;    // factor r = length_ * correction_
  V correction_;
};

/// CubicSpline: with o = R - r and i = R/2 - r, R the support and negative values replaced by 0, W = C (2/R)^3 (o^3 - 4
/// i^3).
template <class D>
class CubicSplineLanes {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  static double ValueFactor(double support, double unit) { return Constant(support) * unit * unit * unit; }
  static double SlopeFactor(double support, double unit) { return 3 * Constant(support) * unit * unit; }

  CubicSplineLanes(D d, T support)
      : d_(d),
        support_(hn::Set(d, support)),
        cube_root_of_4_(hn::Set(d, static_cast<T>(1.5874010519681994748))),
        minus_half_support_scaled_(hn::Set(d, static_cast<T>(-0.5 * 1.5874010519681994748) * support)),
        minus_support_(hn::Set(d, -support)) {}

  /// sum + o^3 - 4 i^3
  HWY_INLINE V AddValue(V r2, V sum) const {
    const V outer = Distance<D>(d_, r2).SubtractedFrom(support_);
    const V inner = hn::Max(hn::MulAdd(outer, cube_root_of_4_, minus_half_support_scaled_), hn::Zero(d_));
    const V o = hn::Max(outer, hn::Zero(d_));
    return hn::NegMulAdd(hn::Mul(inner, inner), inner, hn::MulAdd(hn::Mul(o, o), o, sum));
  }
  /// (o^2 - 4 i^2)/r, which is -W'/r without the factor 3 C (2/R)^3
  HWY_INLINE V NegativeSlopeOverR(V r2) const {
    const Distance<D> r(d_, r2);
    const V outer = r.SubtractedFrom(support_);
    const V twice_inner = hn::Max(hn::MulAdd(outer, hn::Set(d_, static_cast<T>(2)), minus_support_), hn::Zero(d_));
    const V o = hn::Max(outer, hn::Zero(d_));
    return hn::Mul(hn::NegMulAdd(twice_inner, twice_inner, hn::Mul(o, o)), r.Inverse());
  }

 private:
  /// C/h^3 [1/m^5]
  static double Constant(double support) {
    const double h = 0.5 * support;
    return 5 / (14 * std::numbers::pi * h * h * h * h * h);
  }

  D d_;
  V support_;
  V cube_root_of_4_;
  V minus_half_support_scaled_;
  V minus_support_;
};

/// Poly6: sum + (1 - r^2/R^2)^3.
template <class D>
class Poly6Lanes {
 public:
  using V = hn::Vec<D>;

  static double ValueFactor(double support, double) { return 4 / (std::numbers::pi * support * support); }

  Poly6Lanes(D d, hn::TFromD<D> support) : d_(d), per_support2_(hn::Set(d, 1 / (support * support))) {}

  HWY_INLINE V AddValue(V r2, V sum) const {
    const V one = hn::Set(d_, static_cast<hn::TFromD<D>>(1));
    const V rest = hn::Max(hn::NegMulAdd(r2, per_support2_, one), hn::Zero(d_));
    return hn::MulAdd(hn::Mul(rest, rest), rest, sum);
  }

 private:
  D d_;
  V per_support2_;
};

/// Wendland C2 with s = r/R: W = C (1-s)^4 (1+4s), -W'/r = 20 C/R^2 (1-s)^3, C = 7/(pi R^2).
template <class D>
class WendlandC2Lanes {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  static double ValueFactor(double support, double) { return 7 / (std::numbers::pi * support * support); }
  static double SlopeFactor(double support, double unit) {
    return 20 * ValueFactor(support, unit) * unit / (support * support);
  }

  WendlandC2Lanes(D d, T support) : d_(d), per_support_(1 / support) {}

  /// By what it multiplies lengths.
  T Factor() const { return per_support_; }
  HWY_INLINE Distance<D> DistanceOf(V r2) const { return {d_, r2, per_support_}; }
  /// 1 - s, not below 0
  HWY_INLINE V At(const Distance<D>& s) const { return hn::Max(s.SubtractedFrom(hn::Set(d_, T(1))), hn::Zero(d_)); }
  HWY_INLINE V AddValue(V r2, V sum) const { return hn::Add(ValueOf(At(DistanceOf(r2))), sum); }
  HWY_INLINE V NegativeSlopeOverR(V r2) const { return SlopeOf(At(DistanceOf(r2))); }
  /// The same from what At has found, where both are wanted.
  HWY_INLINE V ValueOf(V rest) const {
    const V square = hn::Mul(rest, rest);
    const V linear = hn::NegMulAdd(rest, hn::Set(d_, T(4)), hn::Set(d_, T(5)));
    return hn::Mul(hn::Mul(square, square), linear);
  }
  HWY_INLINE V SlopeOf(V rest) const { return hn::Mul(hn::Mul(rest, rest), rest); }

 private:
  D d_;
  T per_support_;
};

/// Wendland C4: W = C/3 (1-s)^6 (35 s^2 + 18 s + 3), -W'/r = 56/3 C/R^2 (1-s)^5 (1 + 5s), C = 9/(pi R^2).
template <class D>
class WendlandC4Lanes {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  static double ValueFactor(double support, double) { return 3 / (std::numbers::pi * support * support); }
  static double SlopeFactor(double support, double unit) {
    return 56 * ValueFactor(support, unit) * unit / (support * support);
  }

  WendlandC4Lanes(D d, T support) : d_(d), rest_(d, support) {}

  T Factor() const { return rest_.Factor(); }
  HWY_INLINE Distance<D> DistanceOf(V r2) const { return rest_.DistanceOf(r2); }
  HWY_INLINE V At(const Distance<D>& s) const { return rest_.At(s); }
  HWY_INLINE V AddValue(V r2, V sum) const { return hn::Add(ValueOf(At(DistanceOf(r2))), sum); }
  HWY_INLINE V NegativeSlopeOverR(V r2) const { return SlopeOf(At(DistanceOf(r2))); }
  HWY_INLINE V ValueOf(V rest) const {
    // 35 s^2 + 18 s + 3 in powers of 1 - s
    const V square = hn::Mul(rest, rest);
    const V inner = hn::MulAdd(rest, hn::Set(d_, T(35)), hn::Set(d_, T(-88)));
    const V polynomial = hn::MulAdd(inner, rest, hn::Set(d_, T(56)));
    return hn::Mul(hn::Mul(square, hn::Mul(square, square)), polynomial);
  }
  HWY_INLINE V SlopeOf(V rest) const {
    const V square = hn::Mul(rest, rest);
    const V linear = hn::NegMulAdd(rest, hn::Set(d_, T(5)), hn::Set(d_, T(6)));
    return hn::Mul(hn::Mul(hn::Mul(square, square), rest), linear);
  }

 private:
  D d_;
  WendlandC2Lanes<D> rest_;
};

/// Quintic spline, q = 3s: W = C ((3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5), -W'/r = 45 C/R^2 ((3-q)^4 - 6 (2-q)^4 + 15
/// (1-q)^4)/q, C = 63/(478 pi R^2), each power only where its base is positive.
template <class D>
class QuinticSplineLanes {
 public:
  using V = hn::Vec<D>;
  using T = hn::TFromD<D>;

  static double ValueFactor(double support, double) { return 63 / (478 * std::numbers::pi * support * support); }
  static double SlopeFactor(double support, double unit) {
    return 45 * ValueFactor(support, unit) * unit / (support * support);
  }

  QuinticSplineLanes(D d, T support) : d_(d), per_h_(3 / support) {}

  struct Place {
    V outer;  // 3 - q, not below 0
    V per_q;
  };
  T Factor() const { return per_h_; }
  HWY_INLINE Distance<D> DistanceOf(V r2) const { return {d_, r2, per_h_}; }
  HWY_INLINE Place At(const Distance<D>& q) const {
    return {Positive(q.SubtractedFrom(Set(3))), hn::Mul(q.Inverse(), hn::Set(d_, 1 / (per_h_ * per_h_)))};
  }
  HWY_INLINE V AddValue(V r2, V sum) const { return hn::Add(ValueOf(At(DistanceOf(r2))), sum); }
  HWY_INLINE V NegativeSlopeOverR(V r2) const { return SlopeOf(At(DistanceOf(r2))); }
  HWY_INLINE V ValueOf(const Place& place) const {
    const V middle = Positive(hn::Sub(place.outer, Set(1)));
    const V inner = Positive(hn::Sub(place.outer, Set(2)));
    const V sum =
        hn::NegMulAdd(FourthPower(middle), hn::Mul(middle, Set(6)), hn::Mul(FourthPower(place.outer), place.outer));
    return hn::MulAdd(FourthPower(inner), hn::Mul(inner, Set(15)), sum);
  }
  HWY_INLINE V SlopeOf(const Place& place) const {
    const V middle = Positive(hn::Sub(place.outer, Set(1)));
    const V far = hn::Mul(hn::NegMulAdd(FourthPower(middle), Set(6), FourthPower(place.outer)), place.per_q);
    // Where q < 1 the powers multiplied out, because over a small q their round-off would count.
    const V q = hn::Sub(Set(3), place.outer);
    const V near = hn::MulAdd(hn::Mul(q, q), hn::MulAdd(q, Set(10), Set(-24)), Set(24));
    return hn::IfThenElse(hn::Lt(q, Set(1)), near, far);
  }

 private:
  HWY_INLINE V Set(double value) const { return hn::Set(d_, static_cast<T>(value)); }
  HWY_INLINE V Positive(V values) const { return hn::Max(values, hn::Zero(d_)); }
  HWY_INLINE static V FourthPower(V values) {
    const V square = hn::Mul(values, values);
    return hn::Mul(square, square);
  }

  D d_;
  T per_h_;
};

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#ifndef SPH_WITH_KERNEL
// Calls pass<Real, Lanes>(arguments) with the lanes of that SmoothingKernel.
#define SPH_WITH_KERNEL(kernel, Real, pass, ...)          \
  switch (kernel) {                                       \
    case SmoothingKernel::kWendlandC2:                    \
      return pass<Real, WendlandC2Lanes>(__VA_ARGS__);    \
    case SmoothingKernel::kWendlandC4:                    \
      return pass<Real, WendlandC4Lanes>(__VA_ARGS__);    \
    case SmoothingKernel::kQuintic:                       \
      return pass<Real, QuinticSplineLanes>(__VA_ARGS__); \
  }
#endif

#endif  // per-target include guard
