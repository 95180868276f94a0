// The pass over wall particles; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sph/wall_particles.cpp"
#include "sph/wall_particles.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <limits>

#include "sph/cluster_pairs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <typename Real, template <class> class Kernel>
void Means(const PassInput<Real>& input, const WaterInput<Real>& water, const ClusterSet& walls, const ListBlock& block,
           Vec2 gravity, double sound, WallValues<Real>& values) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<Real>(value)); };
  const double unit = Positions<Real>::Unit(input.support);
  const auto gx = set(gravity.x * unit), gy = set(gravity.y * unit), per_c2 = set(1 / (sound * sound));
  const auto rho0 = set(water.rho0), one = set(1), zero = hn::Zero(d);
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = walls.clusters[k];
    auto sum = zero, weight_of = zero, pressure = zero, excess = zero, vx = zero, vy = zero, wholeness = zero;
    pairs.ForEach({walls.first + cluster.first, cluster.count}, block.Of(k),
                  [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
                    const auto value = kernel.AddValue(r2, zero);
                    const auto excess_j = hn::Set(d, water.excess[j]);
                    const auto drop = hn::Mul(hn::Add(excess_j, rho0), hn::MulAdd(dx, gx, hn::Mul(dy, gy)));
                    sum = hn::Add(sum, value);
                    weight_of = hn::MulAdd(value, drop, weight_of);
                    pressure = hn::MulAdd(value, hn::Set(d, water.pressure[j]), pressure);
                    excess = hn::MulAdd(value, excess_j, excess);
                    vx = hn::MulAdd(value, hn::Set(d, water.vx[j]), vx);
                    vy = hn::MulAdd(value, hn::Set(d, water.vy[j]), vy);
                    wholeness = hn::MulAdd(value, hn::Set(d, water.wholeness[j]), wholeness);
                  });
    const auto some = hn::Ge(sum, set(std::numeric_limits<Real>::min()));  // the inverse of less is no number
    const auto per_sum = hn::IfThenElseZero(some, hn::Div(one, hn::IfThenElse(some, sum, one)));
    const auto store = [&](auto total, std::vector<Real>& to)
                           HWY_ATTR { StoreCluster(d, hn::Mul(total, per_sum), cluster, to.data()); };
    store(hn::Add(pressure, weight_of), values.pressure);
    store(hn::MulAdd(weight_of, per_c2, excess), values.excess);
    store(vx, values.vx);
    store(vy, values.vy);
    store(wholeness, values.wholeness);
  }
}

}  // namespace

#define SPH_PASS_OF(Real, Name)                                                                          \
  void Means##Name(const PassInput<Real>& input, const WaterInput<Real>& water, const ClusterSet& walls, \
                   const ListBlock& block, Vec2 gravity, double sound, WallValues<Real>& values) {       \
    SPH_WITH_KERNEL(water.kernel, Real, Means, input, water, walls, block, gravity, sound, values)       \
  }
SPH_PASS_OF(float, Float)
SPH_PASS_OF(double, Double)
#undef SPH_PASS_OF

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sph {

#define SPH_DISPATCH(Real, Name)                                                                                     \
  HWY_EXPORT(Means##Name);                                                                                           \
  template <>                                                                                                        \
  void ComputeWallValues<Real>(const PassInput<Real>& input, const WaterInput<Real>& water, const ClusterSet& walls, \
                               const ListBlock& block, Vec2 gravity, double sound, WallValues<Real>& values) {       \
    HWY_DYNAMIC_DISPATCH(Means##Name)(input, water, walls, block, gravity, sound, values);                           \
  }
SPH_DISPATCH(float, Float)
SPH_DISPATCH(double, Double)
#undef SPH_DISPATCH

}  // namespace sph
#endif  // HWY_ONCE
