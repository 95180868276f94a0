// The passes over neighbours on vectors; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sph/cluster_passes.cpp"
#include "sph/cluster_passes.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <cmath>
#include <numbers>

#include "sph/cluster_pairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

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
    DensityOf<Real, CubicSplineLanes>(input, block, density);                                                        \
  }                                                                                                                  \
  void Poly6Density##Name(const PassInput<Real>& input, ListBlock& block, Real* density) {                           \
    DensityOf<Real, Poly6Lanes>(input, block, density);                                                              \
  }                                                                                                                  \
  void CubicSplinePressure##Name(const PassInput<Real>& input, const ListBlock& block, const Real* term, double* ax, \
                                 double* ay) {                                                                       \
    PressureOf<Real, CubicSplineLanes>(input, block, term, ax, ay);                                                  \
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
