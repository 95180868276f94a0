// The passes over neighbours on vectors; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sph/cluster_passes.cpp"
#include "sph/cluster_passes.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <cmath>
#include <numbers>

#include "sph/kernel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE auto LoadCoordinates(hn::ScalableTag<float> d, const std::int32_t* x) {
  return hn::LoadU(hn::RebindToSigned<decltype(d)>(), x);
}
HWY_INLINE auto LoadCoordinates(hn::ScalableTag<double> d, const double* x) { return hn::LoadU(d, x); }

/// x_i - x_j for the lanes i; exact for fixed-point coordinates.
template <class VI>
HWY_INLINE auto Difference(hn::ScalableTag<float> d, VI x, std::int32_t xj) {
  const hn::RebindToSigned<decltype(d)> di;
  return hn::ConvertTo(d, hn::Sub(x, hn::Set(di, xj)));
}
template <class V>
HWY_INLINE V Difference(hn::ScalableTag<double> d, V x, double xj) {
  return hn::Sub(x, hn::Set(d, xj));
}

/// The lanes of one cluster against the particles of its list.
template <typename Real>
class Pairs {
 public:
  using D = hn::ScalableTag<Real>;
  using V = hn::Vec<D>;

  Pairs(const PassInput<Real>& input)
      : x_(input.positions->X()),
        y_(input.positions->Y()),
        support_(static_cast<Real>(input.support / Positions<Real>::Unit(input.support))) {}

  /// Support radius in the coordinates' unit.
  Real Support() const { return support_; }

  /// Calls term(j, dx, dy, r2) for every j of the list, dx = x_i - x_j and so on in the coordinates' unit.
  template <class Term>
  HWY_INLINE void ForEach(const Cluster& cluster, std::span<const std::uint32_t> list, Term term) const {
    const D d;
    const auto x = LoadCoordinates(d, x_ + cluster.first);
    const auto y = LoadCoordinates(d, y_ + cluster.first);
    const Real least = support_ * Real(1e-15);  // so that 1/r exists for coincident particles, whose dx and dy are 0
    const V tiny = hn::Set(d, least * least);
    for (const std::uint32_t j : list) {
      const V dx = Difference(d, x, x_[j]);
      const V dy = Difference(d, y, y_[j]);
      term(j, dx, dy, hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, tiny)));
    }
  }

 private:
  const typename Positions<Real>::Coordinate* x_;
  const typename Positions<Real>::Coordinate* y_;
  Real support_;
};

/// Stores the lanes that the cluster has.
template <class D, class V>
HWY_INLINE void StoreCluster(D d, V values, const Cluster& cluster, hn::TFromD<D>* to) {
  if (cluster.count == hn::Lanes(d)) {
    hn::StoreU(values, d, to + cluster.first);
  } else {
    hn::BlendedStore(values, hn::FirstN(d, cluster.count), d, to + cluster.first);
  }
}

HWY_INLINE void AddLanes(hn::ScalableTag<double> d, hn::Vec<hn::ScalableTag<double>> values, const Cluster& cluster,
                         double* to) {
  if (cluster.count == hn::Lanes(d)) {
    hn::StoreU(hn::Add(hn::LoadU(d, to + cluster.first), values), d, to + cluster.first);
    return;
  }
  HWY_ALIGN double lanes[hn::MaxLanes(d)];
  hn::Store(values, d, lanes);
  for (std::uint32_t k = 0; k < cluster.count; ++k) to[cluster.first + k] += lanes[k];
}
HWY_INLINE void AddLanes(hn::ScalableTag<float> d, hn::Vec<hn::ScalableTag<float>> values, const Cluster& cluster,
                         double* to) {
#if HWY_TARGET != HWY_SCALAR
  if (cluster.count == hn::Lanes(d)) {
    const hn::Half<decltype(d)> half;
    const hn::ScalableTag<double> dd;
    double* const lower = to + cluster.first;
    double* const upper = lower + hn::Lanes(dd);
    hn::StoreU(hn::Add(hn::LoadU(dd, lower), hn::PromoteTo(dd, hn::LowerHalf(half, values))), dd, lower);
    hn::StoreU(hn::Add(hn::LoadU(dd, upper), hn::PromoteTo(dd, hn::UpperHalf(half, values))), dd, upper);
    return;
  }
#endif
  HWY_ALIGN float lanes[hn::MaxLanes(d)];
  hn::Store(values, d, lanes);
  for (std::uint32_t k = 0; k < cluster.count; ++k) to[cluster.first + k] += static_cast<double>(lanes[k]);
}

template <typename Real, template <class> class Kernel, bool kEqualMasses, bool kRefine>
void Density(const PassInput<Real>& input, ListBlock& block, double constant, Real* density) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const auto factor = hn::Set(d, static_cast<Real>(constant));
  // A little further than the lists' reach, against round-off.
  const Real reach = pairs.Support() * static_cast<Real>(input.reach / input.support * (1 + 1e-6));
  const auto reach2 = hn::Set(d, reach * reach);
  std::uint32_t* const numbers = block.numbers.data();
  std::uint32_t begin = 0;
  std::uint32_t kept = 0;
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    auto sum = hn::Zero(d);
    std::uint32_t& end = block.begin[k - block.first + 1];
    pairs.ForEach(input.clusters[k], {numbers + begin, numbers + end},
                  [&]([[maybe_unused]] std::uint32_t j, auto, auto, auto r2) HWY_ATTR {
                    if constexpr (kRefine) {
                      numbers[kept] = j;
                      kept += hn::AllFalse(d, hn::Lt(r2, reach2)) ? 0 : 1;
                    }
                    if constexpr (kEqualMasses) {
                      sum = kernel.AddValue(r2, sum);
                    } else {
                      sum = hn::MulAdd(hn::Set(d, input.mass[j]), kernel.AddValue(r2, hn::Zero(d)), sum);
                    }
                  });
    StoreCluster(d, hn::Mul(sum, factor), input.clusters[k], density);
    begin = end;
    if constexpr (kRefine) end = kept;
  }
  if constexpr (kRefine) block.coarse = false;
}

/// `constant` makes an integral of 1 of the kernel's value without constants; powers of the support in it are those of
/// metres.
template <typename Real, template <class> class Kernel>
void DensityOf(const PassInput<Real>& input, ListBlock& block, double constant, int power, Real* density) {
  const double in_units = constant * std::pow(Positions<Real>::Unit(input.support), power);
  if (input.mass == nullptr) {
    const double in_kilograms = in_units * input.equal_mass;
    if (block.coarse) return Density<Real, Kernel, true, true>(input, block, in_kilograms, density);
    return Density<Real, Kernel, true, false>(input, block, in_kilograms, density);
  }
  if (block.coarse) return Density<Real, Kernel, false, true>(input, block, in_units, density);
  return Density<Real, Kernel, false, false>(input, block, in_units, density);
}

double CubicSplineConstant(double support) {
  const double h = 0.5 * support;
  return 5 / (14 * std::numbers::pi * h * h * h * h * h);  // C/h^3
}

template <typename Real>
void CubicSplineDensity(const PassInput<Real>& input, ListBlock& block, Real* density) {
  DensityOf<Real, CubicSplineLanes>(input, block, CubicSplineConstant(input.support), 3, density);
}

template <typename Real>
void Poly6Density(const PassInput<Real>& input, ListBlock& block, Real* density) {
  DensityOf<Real, Poly6Lanes>(input, block, 4 / (std::numbers::pi * input.support * input.support), 0, density);
}

template <typename Real, bool kEqualMasses>
void Pressure(const PassInput<Real>& input, const ListBlock& block, const Real* pressure_term, double* ax, double* ay) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const CubicSplineLanes<decltype(d)> kernel(d, pairs.Support());
  // W' is per metre, o^2 in units^2, dx/r has no unit.
  const double unit = Positions<Real>::Unit(input.support);
  const double constant =
      3 * CubicSplineConstant(input.support) * unit * unit * (kEqualMasses ? input.equal_mass : 1.0);
  const auto factor = hn::Set(d, static_cast<Real>(constant));
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = input.clusters[k];
    const auto own_term = hn::LoadU(d, pressure_term + cluster.first);
    auto sum_x = hn::Zero(d);
    auto sum_y = hn::Zero(d);
    pairs.ForEach(cluster, block.Of(k), [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
      auto terms = hn::Add(own_term, hn::Set(d, pressure_term[j]));
      if constexpr (!kEqualMasses) terms = hn::Mul(terms, hn::Set(d, input.mass[j]));
      const auto push = hn::Mul(terms, kernel.NegativeSlopeOverR(r2));
      sum_x = hn::MulAdd(push, dx, sum_x);
      sum_y = hn::MulAdd(push, dy, sum_y);
    });
    AddLanes(d, hn::Mul(sum_x, factor), cluster, ax);
    AddLanes(d, hn::Mul(sum_y, factor), cluster, ay);
  }
}

template <typename Real>
void CubicSplinePressure(const PassInput<Real>& input, const ListBlock& block, const Real* term, double* ax,
                         double* ay) {
  if (input.mass == nullptr) {
    Pressure<Real, true>(input, block, term, ax, ay);
  } else {
    Pressure<Real, false>(input, block, term, ax, ay);
  }
}

template <typename Real, bool kPublished, bool kViscous>
void Mueller(const PassInput<Real>& input, const MuellerInput<Real>& mueller, const ListBlock& block, double* ax,
             double* ay) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const double unit = Positions<Real>::Unit(input.support);
  const double per_h5 = 1 / (std::numbers::pi * std::pow(input.support, 5));
  // -(P_i + P_j)/2 W'(r), W' being -30/(pi h^5) (h-r)^2 or the published 10/(pi h^5) (h-r)^3.
  const double slope = 0.5 * (kPublished ? -10 * per_h5 * unit * unit * unit : 30 * per_h5 * unit * unit);
  const auto pressure_factor = hn::Set(d, static_cast<Real>(slope));
  const auto viscosity_factor = hn::Set(d, static_cast<Real>(40 * per_h5 * unit * mueller.viscosity));
  const auto support = hn::Set(d, pairs.Support());
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = input.clusters[k];
    const auto own_pressure = hn::LoadU(d, mueller.pressure + cluster.first);
    auto push_x = hn::Zero(d), push_y = hn::Zero(d), drag_x = hn::Zero(d), drag_y = hn::Zero(d);
    auto own_vx = hn::Zero(d), own_vy = hn::Zero(d);
    if constexpr (kViscous) {
      own_vx = hn::LoadU(d, mueller.vx + cluster.first);
      own_vy = hn::LoadU(d, mueller.vy + cluster.first);
    }
    pairs.ForEach(cluster, block.Of(k), [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
      const Distance<decltype(d)> r(d, r2);
      const auto rest = hn::Max(r.SubtractedFrom(support), hn::Zero(d));
      const auto weight = hn::Mul(rest, hn::Set(d, mueller.volume[j]));
      auto push =
          hn::Mul(hn::Mul(weight, rest), hn::Mul(hn::Add(own_pressure, hn::Set(d, mueller.pressure[j])), r.Inverse()));
      if constexpr (kPublished) push = hn::Mul(push, rest);
      push_x = hn::MulAdd(push, dx, push_x);
      push_y = hn::MulAdd(push, dy, push_y);
      if constexpr (kViscous) {
        drag_x = hn::MulAdd(weight, hn::Sub(hn::Set(d, mueller.vx[j]), own_vx), drag_x);
        drag_y = hn::MulAdd(weight, hn::Sub(hn::Set(d, mueller.vy[j]), own_vy), drag_y);
      }
    });
    const auto own_density = hn::LoadU(d, mueller.density + cluster.first);
    const auto total = [&](auto push, auto drag) HWY_ATTR {
      return hn::Div(hn::MulAdd(push, pressure_factor, hn::Mul(drag, viscosity_factor)), own_density);
    };
    AddLanes(d, total(push_x, drag_x), cluster, ax);
    AddLanes(d, total(push_y, drag_y), cluster, ay);
  }
}

template <typename Real>
void MuellerForces(const PassInput<Real>& input, const MuellerInput<Real>& mueller, const ListBlock& block, double* ax,
                   double* ay) {
  const bool viscous = mueller.viscosity != 0;
  if (mueller.published) {
    if (viscous) return Mueller<Real, true, true>(input, mueller, block, ax, ay);
    return Mueller<Real, true, false>(input, mueller, block, ax, ay);
  }
  if (viscous) return Mueller<Real, false, true>(input, mueller, block, ax, ay);
  return Mueller<Real, false, false>(input, mueller, block, ax, ay);
}

}  // namespace

#define SPH_PASSES_OF(Real, Name)                                                                                    \
  void CubicSplineDensity##Name(const PassInput<Real>& input, ListBlock& block, Real* density) {                     \
    CubicSplineDensity<Real>(input, block, density);                                                                 \
  }                                                                                                                  \
  void Poly6Density##Name(const PassInput<Real>& input, ListBlock& block, Real* density) {                           \
    Poly6Density<Real>(input, block, density);                                                                       \
  }                                                                                                                  \
  void CubicSplinePressure##Name(const PassInput<Real>& input, const ListBlock& block, const Real* term, double* ax, \
                                 double* ay) {                                                                       \
    CubicSplinePressure<Real>(input, block, term, ax, ay);                                                           \
  }                                                                                                                  \
  void MuellerForces##Name(const PassInput<Real>& input, const MuellerInput<Real>& mueller, const ListBlock& block,  \
                           double* ax, double* ay) {                                                                 \
    MuellerForces<Real>(input, mueller, block, ax, ay);                                                              \
  }
SPH_PASSES_OF(float, Float)
SPH_PASSES_OF(double, Double)
#undef SPH_PASSES_OF

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sph {

#define SPH_DISPATCH(Real, Name)                                                                                       \
  HWY_EXPORT(CubicSplineDensity##Name);                                                                                \
  HWY_EXPORT(Poly6Density##Name);                                                                                      \
  HWY_EXPORT(CubicSplinePressure##Name);                                                                               \
  HWY_EXPORT(MuellerForces##Name);                                                                                     \
  template <>                                                                                                          \
  void ComputeCubicSplineDensity<Real>(const PassInput<Real>& input, ListBlock& block, Real* density) {                \
    HWY_DYNAMIC_DISPATCH(CubicSplineDensity##Name)(input, block, density);                                             \
  }                                                                                                                    \
  template <>                                                                                                          \
  void ComputePoly6Density<Real>(const PassInput<Real>& input, ListBlock& block, Real* density) {                      \
    HWY_DYNAMIC_DISPATCH(Poly6Density##Name)(input, block, density);                                                   \
  }                                                                                                                    \
  template <>                                                                                                          \
  void AddCubicSplinePressure<Real>(const PassInput<Real>& input, const ListBlock& block, const Real* pressure_term,   \
                                    double* ax, double* ay) {                                                          \
    HWY_DYNAMIC_DISPATCH(CubicSplinePressure##Name)(input, block, pressure_term, ax, ay);                              \
  }                                                                                                                    \
  template <>                                                                                                          \
  void AddMuellerForces<Real>(const PassInput<Real>& input, const MuellerInput<Real>& mueller, const ListBlock& block, \
                              double* ax, double* ay) {                                                                \
    HWY_DYNAMIC_DISPATCH(MuellerForces##Name)(input, mueller, block, ax, ay);                                          \
  }
SPH_DISPATCH(float, Float)
SPH_DISPATCH(double, Double)
#undef SPH_DISPATCH

}  // namespace sph
#endif  // HWY_ONCE
