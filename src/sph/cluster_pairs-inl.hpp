// What the passes over neighbours are made of: the lanes of a cluster against the particles of its list, and density
// and pressure with any kernel. Included once for each instruction set.
#if defined(SPH_CLUSTER_PAIRS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SPH_CLUSTER_PAIRS_INL_HPP
#undef SPH_CLUSTER_PAIRS_INL_HPP
#else
#define SPH_CLUSTER_PAIRS_INL_HPP
#endif

#include <hwy/highway.h>

#include "neighbours/coordinates-inl.hpp"
#include "sph/cluster_passes.hpp"
#include "sph/kernel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {

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

/// Stores the lanes that the cluster has; what follows it belongs to other threads.
template <class D, class V>
HWY_INLINE void StoreCluster(D d, V values, const Cluster& cluster, hn::TFromD<D>* to) {
  if (cluster.count == hn::Lanes(d)) {
    hn::StoreU(values, d, to + cluster.first);
    return;
  }
  HWY_ALIGN hn::TFromD<D> lanes[hn::MaxLanes(d)];
  hn::Store(values, d, lanes);
  for (std::uint32_t k = 0; k < cluster.count; ++k) to[cluster.first + k] = lanes[k];
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

/// Makes a block's lists shorter while a pass walks through them: keeps what is within reach of one of the lanes.
template <typename Real>
class Refinement {
 public:
  using D = hn::ScalableTag<Real>;
  using V = hn::Vec<D>;

  Refinement(const Pairs<Real>& pairs, ListBlock& block)
      : block_(block), numbers_(block.numbers.data()), support_(pairs.Support()) {}

  /// The list of cluster k as it was; to be called for one cluster after the other.
  std::span<const std::uint32_t> Of(std::uint32_t k) {
    const std::uint32_t begin = end_;
    end_ = block_.begin[k - block_.first + 1];
    const Real reach = support_ * static_cast<Real>(block_.reach[k - block_.first]);
    reach2_ = reach * reach;
    return {numbers_ + begin, numbers_ + end_};
  }
  HWY_INLINE void Look(std::uint32_t j, V r2) {
    const D d;
    numbers_[kept_] = j;
    kept_ += hn::AllFalse(d, hn::Lt(r2, hn::Set(d, reach2_))) ? 0 : 1;
  }
  /// After cluster k's list.
  void Close(std::uint32_t k) { block_.begin[k - block_.first + 1] = kept_; }

 private:
  ListBlock& block_;
  std::uint32_t* numbers_;
  Real support_;
  Real reach2_ = 0;
  std::uint32_t end_ = 0;
  std::uint32_t kept_ = 0;
};

template <typename Real, template <class> class Kernel, bool kEqualMasses, bool kRefine>
void Density(const PassInput<Real>& input, ListBlock& block, double constant, Real* density) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const auto factor = hn::Set(d, static_cast<Real>(constant));
  Refinement<Real> refinement(pairs, block);
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    auto sum = hn::Zero(d);
    const auto list = kRefine ? refinement.Of(k) : block.Of(k);
    pairs.ForEach(input.clusters[k], list, [&]([[maybe_unused]] std::uint32_t j, auto, auto, auto r2) HWY_ATTR {
      if constexpr (kRefine) refinement.Look(j, r2);
      if constexpr (kEqualMasses) {
        sum = kernel.AddValue(r2, sum);
      } else {
        sum = hn::MulAdd(hn::Set(d, input.mass[j]), kernel.AddValue(r2, hn::Zero(d)), sum);
      }
    });
    StoreCluster(d, hn::Mul(sum, factor), input.clusters[k], density);
    if constexpr (kRefine) refinement.Close(k);
  }
  if constexpr (kRefine) block.coarse = false;
}

/// ComputeDensity with that kernel.
template <typename Real, template <class> class Kernel>
void DensityOf(const PassInput<Real>& input, ListBlock& block, Real* density) {
  using Lanes = Kernel<hn::ScalableTag<Real>>;
  const double in_units = Lanes::ValueFactor(input.support, Positions<Real>::Unit(input.support));
  if (input.mass == nullptr) {
    const double in_kilograms = in_units * input.equal_mass;
    if (block.coarse) return Density<Real, Kernel, true, true>(input, block, in_kilograms, density);
    return Density<Real, Kernel, true, false>(input, block, in_kilograms, density);
  }
  if (block.coarse) return Density<Real, Kernel, false, true>(input, block, in_units, density);
  return Density<Real, Kernel, false, false>(input, block, in_units, density);
}

template <typename Real, template <class> class Kernel, bool kEqualMasses>
void Pressure(const PassInput<Real>& input, const ListBlock& block, const Real* pressure_term, double* ax, double* ay) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const double constant = Kernel<decltype(d)>::SlopeFactor(input.support, Positions<Real>::Unit(input.support)) *
                          (kEqualMasses ? input.equal_mass : 1.0);
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

/// AddPressure with that kernel.
template <typename Real, template <class> class Kernel>
void PressureOf(const PassInput<Real>& input, const ListBlock& block, const Real* term, double* ax, double* ay) {
  if (input.mass == nullptr) {
    Pressure<Real, Kernel, true>(input, block, term, ax, ay);
  } else {
    Pressure<Real, Kernel, false>(input, block, term, ax, ay);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
