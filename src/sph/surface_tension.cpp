// The passes of surface tension; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sph/surface_tension.cpp"
#include "sph/surface_tension.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sph/cluster_pairs-inl.hpp"

#ifndef SPH_SURFACE_TENSION_ONCE
#define SPH_SURFACE_TENSION_ONCE
namespace sph {
namespace {

/// |grad C| times the support where a flat surface is.
constexpr double kSteepest = 128 / (35 * std::numbers::pi);
/// Fluid inside, whose particles are shifted, fills the support but for some hundredths, and what gradient it has is
/// noise: with more than the second colour nothing counts as a surface, with less than the first all.
constexpr double kSurface = 0.9, kInside = 0.97;

/// Poly6 is this times (1 - (r/R)^2)^3 [1/m^2].
double Poly6Constant(double support) { return 4 / (std::numbers::pi * support * support); }

}  // namespace
}  // namespace sph
#endif

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// 1 - (r/R)^2, or 0 beyond the support. Poly6 is its cube, the gradient of Poly6 over the distance its square, both
/// but for a factor.
template <class D>
HWY_INLINE hn::Vec<D> Nearness(D d, hn::Vec<D> r2, hn::Vec<D> per_support2) {
  return hn::Max(hn::NegMulAdd(r2, per_support2, hn::Set(d, hn::TFromD<D>(1))), hn::Zero(d));
}

/// How far from the surface the colour is c, in supports: C(z) = 1/2 + 128/(35 pi) int_0^z (1 - t^2)^(7/2) dt of a flat
/// surface turned round, to 0.001 as far as z = 0.3 and to 0.007 as far as 0.4; beyond that hardly anything counts.
template <class D>
HWY_INLINE hn::Vec<D> DepthOf(D d, hn::Vec<D> colour) {
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<hn::TFromD<D>>(value)); };
  const auto above = hn::Min(hn::Max(hn::Sub(colour, set(0.5)), hn::Zero(d)), set(0.5));
  return hn::Div(above, hn::NegMulAdd(hn::Mul(above, above), set(kSteepest), set(kSteepest)));
}

template <typename Real>
void Surface(const PassInput<Real>& input, const Real* volume, const ListBlock& block, SurfaceArrays<Real>& arrays) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<Real>(value)); };
  const double support = input.support, reach = pairs.Support();
  const auto per_support2 = set(1 / (reach * reach));
  const auto share_factor = set(Poly6Constant(support));
  const auto factor = set(-6 * Poly6Constant(support) / (support * support) * Positions<Real>::Unit(support));
  const auto metres = set(support), inside = set(kInside), per_fall = set(1 / (kInside - kSurface));
  const auto one = set(1), two = set(2), three = set(3), tiny = set(1e-12 / support);
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = input.clusters[k];
    auto share = hn::Zero(d), x = hn::Zero(d), y = hn::Zero(d);
    pairs.ForEach(cluster, block.Of(k), [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
      const auto near = Nearness(d, r2, per_support2);
      const auto slope = hn::Mul(hn::Set(d, volume[j]), hn::Mul(near, near));
      share = hn::MulAdd(slope, near, share);
      x = hn::MulAdd(slope, dx, x);
      y = hn::MulAdd(slope, dy, y);
    });
    x = hn::Mul(x, factor);
    y = hn::Mul(y, factor);
    const auto steepness = hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y)));
    const auto colour = hn::Mul(share, share_factor);
    const auto part = hn::Min(hn::Max(hn::Mul(hn::Sub(inside, colour), per_fall), hn::Zero(d)), one);
    const auto counts = hn::Mul(hn::Mul(part, part), hn::NegMulAdd(two, part, three));  // rises smoothly
    const auto per_steepness = hn::Div(one, hn::Max(steepness, tiny));
    StoreCluster(d, counts, cluster, arrays.part.data());
    StoreCluster(d, hn::Mul(metres, DepthOf(d, colour)), cluster, arrays.depth.data());
    StoreCluster(d, hn::Mul(x, per_steepness), cluster, arrays.normal_x.data());
    StoreCluster(d, hn::Mul(y, per_steepness), cluster, arrays.normal_y.data());
    StoreCluster(d, hn::Mul(hn::LoadU(d, volume + cluster.first), counts), cluster, arrays.weight.data());
  }
}

template <typename Real, template <class> class Kernel>
void Tension(const PassInput<Real>& input, const SurfaceInput<Real>& surface, const ListBlock& block, double* ax,
             double* ay) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<Real>(value)); };
  const SurfaceArrays<Real>& arrays = *surface.arrays;
  const double reach = pairs.Support(), unit = Positions<Real>::Unit(input.support);
  const auto per_support2 = set(1 / (reach * reach)), per_unit = set(1 / unit);
  // With neighbours in one line there is no telling how the normal turns. No surface turns more within a spacing.
  const auto least = set(1e-4), most = set(4 / input.support), one = set(1), half = set(0.5);
  const auto factor = set(2 * surface.tension * Kernel<decltype(d)>::SlopeFactor(input.support, unit));
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = input.clusters[k];
    const auto own = [&](const Real* values) HWY_ATTR { return hn::LoadU(d, values + cluster.first); };
    const auto part = own(arrays.part.data());
    if (hn::AllTrue(d, hn::Eq(part, hn::Zero(d)))) continue;
    const auto normal_x = own(arrays.normal_x.data()), normal_y = own(arrays.normal_y.data());
    auto xx = hn::Zero(d), xy = xx, yy = xx, turn_xx = xx, turn_across = xx, turn_yy = xx, lack_x = xx, lack_y = xx;
    pairs.ForEach(cluster, block.Of(k), [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
      const auto near = Nearness(d, r2, per_support2);
      const auto weight = hn::Mul(hn::Set(d, arrays.weight[j]), hn::Mul(near, near));
      const auto wx = hn::Mul(weight, dx), wy = hn::Mul(weight, dy);
      const auto turn_x = hn::Sub(normal_x, hn::Set(d, arrays.normal_x[j]));
      const auto turn_y = hn::Sub(normal_y, hn::Set(d, arrays.normal_y[j]));
      xx = hn::MulAdd(wx, dx, xx);
      xy = hn::MulAdd(wx, dy, xy);
      yy = hn::MulAdd(wy, dy, yy);
      turn_xx = hn::MulAdd(turn_x, wx, turn_xx);
      turn_across = hn::MulAdd(turn_x, wy, hn::MulAdd(turn_y, wx, turn_across));
      turn_yy = hn::MulAdd(turn_y, wy, turn_yy);
      const auto slope = hn::Mul(kernel.NegativeSlopeOverR(r2), hn::Set(d, surface.volume[j]));
      lack_x = hn::MulAdd(slope, dx, lack_x);
      lack_y = hn::MulAdd(slope, dy, lack_y);
    });
    const auto trace = hn::Add(xx, yy);
    const auto determinant = hn::NegMulAdd(xy, xy, hn::Mul(xx, yy));
    const auto known = hn::Gt(determinant, hn::Mul(least, hn::Mul(trace, trace)));
    const auto sum = hn::NegMulAdd(xy, turn_across, hn::MulAdd(yy, turn_xx, hn::Mul(xx, turn_yy)));
    const auto divergence = hn::Mul(per_unit, hn::Div(sum, hn::IfThenElse(known, determinant, one)));
    const auto inside = hn::IfThenElseZero(known, hn::Max(hn::Min(hn::Neg(divergence), most), hn::Neg(most)));
    const auto outside = hn::Div(inside, hn::Max(hn::MulAdd(inside, own(arrays.depth.data()), one), half));
    const auto scale = hn::Div(hn::Mul(factor, hn::Mul(part, outside)), own(surface.density));
    AddLanes(d, hn::Neg(hn::Mul(lack_x, scale)), cluster, ax);
    AddLanes(d, hn::Neg(hn::Mul(lack_y, scale)), cluster, ay);
  }
}

}  // namespace

#define SPH_PASSES_OF(Real, Name)                                                                             \
  void Surface##Name(const PassInput<Real>& input, const Real* volume, const ListBlock& block,                \
                     SurfaceArrays<Real>& arrays) {                                                           \
    Surface(input, volume, block, arrays);                                                                    \
  }                                                                                                           \
  void Tension##Name(const PassInput<Real>& input, const SurfaceInput<Real>& surface, const ListBlock& block, \
                     double* ax, double* ay) {                                                                \
    SPH_WITH_KERNEL(surface.kernel, Real, Tension, input, surface, block, ax, ay)                             \
  }
SPH_PASSES_OF(float, Float)
SPH_PASSES_OF(double, Double)
#undef SPH_PASSES_OF

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sph {

namespace {

/// How much of the half of a kernel's gradient that a flat surface has inside s leaves, by quadrature in supports.
template <class Kernel>
double CountedPart() {
  constexpr int kIntervals = 200;
  constexpr double kWidth = 1.0 / kIntervals;
  const Kernel kernel(1 / Kernel::kSupport);
  double colour = 0.5, sum = 0;
  for (int k = 0; k < kIntervals; ++k) {
    const double z = (k + 0.5) * kWidth;
    double gradient = 0;  // int W dy
    for (int m = 0; m < kIntervals; ++m) gradient += 2 * kWidth * kernel.Value(std::hypot(z, (m + 0.5) * kWidth));
    const double change = kWidth * kSteepest * std::pow(1 - z * z, 3.5);
    const double part = std::clamp((kInside - colour - 0.5 * change) / (kInside - kSurface), 0.0, 1.0);
    sum += part * part * (3 - 2 * part) * gradient * kWidth;
    colour += change;
  }
  return 2 * sum;
}

double CountedPart(SmoothingKernel kernel) {
  static const std::array parts = {CountedPart<WendlandC2>(), CountedPart<WendlandC4>(), CountedPart<QuinticSpline>()};
  return parts[static_cast<std::size_t>(kernel)];
}

}  // namespace

double LongestTensionStep(double support, double density, double tension) {
  const double h = 0.5 * support;
  return 0.25 * std::sqrt(density * h * h * h / (2 * std::numbers::pi * tension));
}

#define SPH_DISPATCH(Real, Name)                                                                      \
  HWY_EXPORT(Surface##Name);                                                                          \
  HWY_EXPORT(Tension##Name);                                                                          \
  template <>                                                                                         \
  void ComputeSurface<Real>(const PassInput<Real>& input, const Real* volume, const ListBlock& block, \
                            SurfaceArrays<Real>& arrays) {                                            \
    HWY_DYNAMIC_DISPATCH(Surface##Name)(input, volume, block, arrays);                                \
  }                                                                                                   \
  template <>                                                                                         \
  void AddSurfaceTension<Real>(const PassInput<Real>& input, const SurfaceInput<Real>& surface,       \
                               const ListBlock& block, double* ax, double* ay) {                      \
    SurfaceInput<Real> whole = surface;                                                               \
    whole.tension /= CountedPart(surface.kernel);                                                     \
    HWY_DYNAMIC_DISPATCH(Tension##Name)(input, whole, block, ax, ay);                                 \
  }
SPH_DISPATCH(float, Float)
SPH_DISPATCH(double, Double)
#undef SPH_DISPATCH

}  // namespace sph
#endif  // HWY_ONCE
