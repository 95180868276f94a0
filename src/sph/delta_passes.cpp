// The accurate solver's passes; the target loop of Highway comes first.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sph/delta_passes.cpp"
#include "sph/delta_passes.hpp"

#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <limits>

#include "sph/cluster_pairs-inl.hpp"
#include "sph/septic_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Below this wholeness a particle's neighbours do not tell a gradient.
constexpr double kLeastWholeness = 0.2;
/// Around the surface [Sun et al. 2017]: below the first no shift but apart, and where wholeness falls by more than the
/// second within a support radius none towards the surface.
constexpr double kSurface = 0.55;
constexpr double kFallAtSurface = 0.2;
/// Particles with more than this are away from the surface, where negative pressure must not pull them together.
constexpr double kInside = 0.75;

/// Particles closer than this, in spacings, are on the way to pair: those of an even fluid are 0.8 or more apart.
constexpr double kTooClose = 0.7;
/// How much stronger than the others these push each other apart; less where a surface is near, as thin tongues would
/// run ahead of their water, and where the relative speeds over a support are less than so much of sound's, as it would
/// lift what lies at rest.
constexpr double kPushApart = 2;
constexpr double kRestless = 0.02;

/// The least eigenvalue of the symmetric matrix.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V LeastEigenvalue(D d, V xx, V xy, V yy) {
  const V difference = hn::Sub(xx, yy), twice_xy = hn::Add(xy, xy);
  const V root = hn::Sqrt(hn::MulAdd(difference, difference, hn::Mul(twice_xy, twice_xy)));
  return hn::Mul(hn::Set(d, hn::TFromD<D>(0.5)), hn::Sub(hn::Add(xx, yy), root));
}

template <typename Real, template <class> class Kernel>
void Rates(const PassInput<Real>& input, const WaterInput<Real>& water, const ListBlock& block,
           const DensitySums<Real>& sums) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const double unit = Positions<Real>::Unit(input.support);
  const double slope = Kernel<decltype(d)>::SlopeFactor(input.support, unit);
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<Real>(value)); };
  const auto matrix = set(slope * unit), divergence_factor = set(slope), zero = hn::Zero(d), one = set(1);
  const auto diffusion_factor = set(2 * water.diffusion * slope / unit);
  const auto strain_factor = set(slope * unit / water.variance);
  const auto half_unit = set(0.5 * unit);
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = input.clusters[k];
    const auto own = [&](const Real* values) HWY_ATTR { return hn::LoadU(d, values + cluster.first); };
    const auto vx = own(water.vx), vy = own(water.vy), excess = own(water.excess);
    const auto gx = hn::Mul(own(water.gradient_x), half_unit), gy = hn::Mul(own(water.gradient_y), half_unit);
    auto diffusion = zero, stretch = zero;
    auto xx = zero, xy = zero, yy = zero;                       // sum w r (x) r
    auto ux = zero, uy = zero, shear_x = zero, shear_y = zero;  // sum w du dx, dv dy, du dy, dv dx
    pairs.ForEach(cluster, block.Of(k), [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
      const auto weight = hn::Mul(kernel.NegativeSlopeOverR(r2), hn::Set(d, water.volume[j]));
      const auto wx = hn::Mul(weight, dx), wy = hn::Mul(weight, dy);
      const auto du = hn::Sub(hn::Set(d, water.vx[j]), vx);
      const auto dv = hn::Sub(hn::Set(d, water.vy[j]), vy);
      xx = hn::MulAdd(wx, dx, xx);
      xy = hn::MulAdd(wx, dy, xy);
      yy = hn::MulAdd(wy, dy, yy);
      ux = hn::MulAdd(wx, du, ux);
      uy = hn::MulAdd(wy, dv, uy);
      shear_x = hn::MulAdd(wy, du, shear_x);
      shear_y = hn::MulAdd(wx, dv, shear_y);
      const auto along = hn::MulAdd(du, dx, hn::Mul(dv, dy));
      stretch = hn::MulAdd(hn::Mul(weight, along), along, stretch);
      const auto step = hn::Sub(hn::Set(d, water.excess[j]), excess);
      const auto mean_x = hn::MulAdd(hn::Set(d, water.gradient_x[j]), half_unit, gx);
      const auto mean_y = hn::MulAdd(hn::Set(d, water.gradient_y[j]), half_unit, gy);
      const auto half_psi = hn::MulAdd(mean_x, dx, hn::MulAdd(mean_y, dy, step));
      diffusion = hn::MulAdd(weight, half_psi, diffusion);
    });
    // -div u: the trace of the matrix of du times the inverse of that of dx, or the plain sum.
    const auto plain = hn::Mul(hn::Add(ux, uy), divergence_factor);
    const auto inside = hn::Gt(hn::Mul(LeastEigenvalue(d, xx, xy, yy), matrix), set(kInside));
    const auto determinant = hn::Mul(hn::NegMulAdd(xy, xy, hn::Mul(xx, yy)), set(unit));
    const auto adjoint = hn::NegMulAdd(xy, hn::Add(shear_x, shear_y), hn::MulAdd(ux, yy, hn::Mul(uy, xx)));
    const auto compression = hn::IfThenElse(inside, hn::Div(adjoint, hn::IfThenElse(inside, determinant, one)), plain);
    const auto density = hn::Add(excess, set(water.rho0));
    StoreCluster(d, hn::MulAdd(diffusion, diffusion_factor, hn::Mul(density, compression)), cluster, sums.rate);
    StoreCluster(d, hn::Sqrt(hn::Mul(stretch, strain_factor)), cluster, sums.strain);
  }
}

/// Sums of the force pass that tell where a particle's neighbours are, and what follows from them.
template <class D>
class Surroundings {
 public:
  using V = hn::Vec<D>;
  using Real = hn::TFromD<D>;

  explicit Surroundings(D d)
      : d_(d),
        xx_(hn::Zero(d)),
        xy_(xx_),
        yy_(xx_),
        rise_x_(xx_),
        rise_y_(xx_),
        fall_x_(xx_),
        fall_y_(xx_),
        lack_x_(xx_),
        lack_y_(xx_),
        near_x_(xx_),
        near_y_(xx_),
        concentration_(xx_) {}

  /// A neighbour j at a distance of (-dx, -dy).
  struct Neighbour {
    V dx, dy;
    V wx, wy;     // V_j (-W'/r) (dx, dy)
    V value;      // V_j W
    V rise;       // difference j - i of density
    V wholeness;  // of j
    V bias;       // 1 + 0.2 (W/W(dx))^4
    V closeness;  // 1 - (r/(0.7 dx))^2, not below 0
  };
  HWY_INLINE void Add(const Neighbour& j, V wholeness) {
    xx_ = hn::MulAdd(j.wx, j.dx, xx_);
    xy_ = hn::MulAdd(j.wx, j.dy, xy_);
    yy_ = hn::MulAdd(j.wy, j.dy, yy_);
    rise_x_ = hn::NegMulAdd(j.wx, j.rise, rise_x_);
    rise_y_ = hn::NegMulAdd(j.wy, j.rise, rise_y_);
    const V fall = hn::Sub(j.wholeness, wholeness);
    fall_x_ = hn::NegMulAdd(j.wx, fall, fall_x_);
    fall_y_ = hn::NegMulAdd(j.wy, fall, fall_y_);
    lack_x_ = hn::NegMulAdd(j.wx, j.bias, lack_x_);
    lack_y_ = hn::NegMulAdd(j.wy, j.bias, lack_y_);
    near_x_ = hn::NegMulAdd(j.wx, j.closeness, near_x_);
    near_y_ = hn::NegMulAdd(j.wy, j.closeness, near_y_);
    concentration_ = hn::Add(concentration_, j.value);
  }

  /// slope, value = the kernel's factors, unit = metres of a coordinate's unit
  HWY_INLINE void Store(double slope, double value, double unit, double support, const Cluster& cluster,
                        const WaterInput<Real>& water, const WaterSums<Real>& sums) const {
    const V per_metre = Set(slope);
    const V matrix = Set(slope * unit);
    const V xx = hn::Mul(xx_, matrix), xy = hn::Mul(xy_, matrix), yy = hn::Mul(yy_, matrix);
    const V wholeness = LeastEigenvalue(d_, xx, xy, yy);
    const auto known = hn::Gt(wholeness, Set(kLeastWholeness));
    const V determinant = hn::NegMulAdd(xy, xy, hn::Mul(xx, yy));
    const V scale = hn::IfThenElseZero(known, hn::Div(per_metre, hn::IfThenElse(known, determinant, Set(1))));
    const auto corrected = [&](V x, V y, V& to_x, V& to_y) HWY_ATTR {
      to_x = hn::Mul(scale, hn::NegMulAdd(xy, y, hn::Mul(yy, x)));
      to_y = hn::Mul(scale, hn::NegMulAdd(xy, x, hn::Mul(xx, y)));
    };
    V gx, gy, nx, ny;
    corrected(rise_x_, rise_y_, gx, gy);
    corrected(fall_x_, fall_y_, nx, ny);
    StoreCluster(d_, wholeness, cluster, sums.wholeness);
    StoreCluster(d_, gx, cluster, sums.gradient_x);
    StoreCluster(d_, gy, cluster, sums.gradient_y);
    // The shift goes against `lack`; where wholeness grows in that direction it leads inwards.
    V sx = hn::Mul(lack_x_, per_metre), sy = hn::Mul(lack_y_, per_metre);
    const V steepness2 = hn::MulAdd(nx, nx, hn::Mul(ny, ny));
    const V along = hn::MulAdd(sx, nx, hn::Mul(sy, ny));
    const double threshold = kFallAtSurface / support;
    const auto steep = hn::Gt(steepness2, Set(threshold * threshold));
    StoreCluster(d_, hn::IfThenZeroElse(steep, hn::Mul(concentration_, Set(value))), cluster, sums.concentration);
    const auto outwards = hn::And(steep, hn::Gt(along, hn::Zero(d_)));
    const V normal_part = hn::IfThenElseZero(outwards, hn::Div(along, hn::Max(steepness2, Set(threshold * threshold))));
    const auto inside = hn::Gt(wholeness, Set(kSurface));
    const V strain = hn::LoadU(d_, water.strain + cluster.first);
    const V deep = hn::Min(hn::Mul(wholeness, Set(1 / kSurface)), Set(1));
    const V restless = hn::Min(hn::Mul(strain, Set(support / (kRestless * water.sound))), Set(1));
    const V apart = hn::Mul(hn::Mul(deep, restless), Set(kPushApart * slope));
    sx = hn::MulAdd(near_x_, apart, hn::IfThenElseZero(inside, hn::NegMulAdd(normal_part, nx, sx)));
    sy = hn::MulAdd(near_y_, apart, hn::IfThenElseZero(inside, hn::NegMulAdd(normal_part, ny, sy)));
    StoreCluster(d_, sx, cluster, sums.shift_x);
    StoreCluster(d_, sy, cluster, sums.shift_y);
  }

 private:
  HWY_INLINE V Set(double value) const { return hn::Set(d_, static_cast<Real>(value)); }

  D d_;
  V xx_, xy_, yy_;
  V rise_x_, rise_y_, fall_x_, fall_y_, lack_x_, lack_y_, near_x_, near_y_;
  V concentration_;
};

/// kMaySharpen: the push has weights of its own if the input wants them; else it never has.
template <typename Real, template <class> class Kernel, bool kMaySharpen, bool kViscous, bool kArtificial>
void Forces(const PassInput<Real>& input, const WaterInput<Real>& water, ListBlock& block, double* ax, double* ay,
            const WaterSums<Real>& sums) {
  const hn::ScalableTag<Real> d;
  const Pairs<Real> pairs(input);
  const Kernel<decltype(d)> kernel(d, pairs.Support());
  const double unit = Positions<Real>::Unit(input.support);
  const double slope = Kernel<decltype(d)>::SlopeFactor(input.support, unit);
  const double value_factor = Kernel<decltype(d)>::ValueFactor(input.support, unit);
  const auto set = [&](double value) HWY_ATTR { return hn::Set(d, static_cast<Real>(value)); };
  const auto one = set(1), zero = hn::Zero(d);
  const SepticLaplacianLanes<decltype(d)> laplacian(d, pairs.Support());
  const auto push_factor = set(slope * water.gradient_flat),
             drag_factor = set(2 * water.viscosity * laplacian.Factor(input.support));
  const double brake = water.artificial / water.gradient_flat;  // it has no part in these weights
  const auto brake_factor = set(brake / (unit * kernel.Factor() * kernel.Factor()));
  const auto square_of = [](auto value) HWY_ATTR { return hn::Mul(value, value); };
  const auto at_spacing = kernel.ValueOf(kernel.At(kernel.DistanceOf(square_of(set(water.spacing / unit)))));
  const auto bias_factor = hn::Div(set(0.2), square_of(square_of(at_spacing)));
  const double too_close = kTooClose * water.spacing / unit;
  const auto per_close2 = set(1 / (too_close * too_close));
  const double support = pairs.Support();
  const auto least_inside = set(water.tensile_control ? kInside : std::numeric_limits<double>::infinity());
  const auto push_fall = set(water.gradient_fall / (water.gradient_flat * support * support));
  const bool refine = block.coarse;
  Refinement<Real> refinement(pairs, block);
  for (std::uint32_t k = block.first; k < block.last; ++k) {
    const Cluster& cluster = input.clusters[k];
    const auto own = [&](const Real* values) HWY_ATTR { return hn::LoadU(d, values + cluster.first); };
    const auto excess = own(water.excess), wholeness = own(water.wholeness), pressure = own(water.pressure);
    const auto vx = own(water.vx), vy = own(water.vy);
    const auto pulls = hn::And(hn::Lt(pressure, zero), hn::Gt(wholeness, least_inside));
    const auto own_pressure = hn::IfThenElse(pulls, hn::Neg(pressure), pressure);
    auto push_x = zero, push_y = zero, drag_x = zero, drag_y = zero;
    Surroundings<decltype(d)> around(d);
    const auto list = refine ? refinement.Of(k) : block.Of(k);
    pairs.ForEach(cluster, list, [&](std::uint32_t j, auto dx, auto dy, auto r2) HWY_ATTR {
      if (refine) refinement.Look(j, r2);
      const auto distance = kernel.DistanceOf(r2);
      const auto place = kernel.At(distance);
      const auto volume = hn::Set(d, water.volume[j]);
      const auto weight = hn::Mul(kernel.SlopeOf(place), volume);
      const auto wx = hn::Mul(weight, dx), wy = hn::Mul(weight, dy);
      auto push = hn::Add(own_pressure, hn::Set(d, water.pressure[j]));
      if constexpr (kMaySharpen) push = hn::Mul(push, hn::NegMulAdd(r2, push_fall, one));
      if constexpr (kViscous || kArtificial) {
        const auto du = hn::Sub(hn::Set(d, water.vx[j]), vx);
        const auto dv = hn::Sub(hn::Set(d, water.vy[j]), vy);
        if constexpr (kViscous) {
          const auto drag = hn::Mul(laplacian.Of(r2), volume);
          drag_x = hn::MulAdd(drag, du, drag_x);
          drag_y = hn::MulAdd(drag, dv, drag_y);
        }
        if constexpr (kArtificial) {
          const auto along = hn::MulAdd(du, dx, hn::Mul(dv, dy)), per_length = distance.Inverse();
          push = hn::MulAdd(hn::Mul(hn::Mul(along, per_length), per_length), brake_factor, push);
        }
      }
      push_x = hn::MulAdd(wx, push, push_x);
      push_y = hn::MulAdd(wy, push, push_y);
      const auto value = kernel.ValueOf(place);
      around.Add({.dx = dx,
                  .dy = dy,
                  .wx = wx,
                  .wy = wy,
                  .value = hn::Mul(value, volume),
                  .rise = hn::Sub(hn::Set(d, water.excess[j]), excess),
                  .wholeness = hn::Set(d, water.wholeness[j]),
                  .bias = hn::MulAdd(square_of(square_of(value)), bias_factor, one),
                  .closeness = hn::Max(hn::NegMulAdd(r2, per_close2, one), zero)},
                 wholeness);
    });
    const auto per_density = hn::Div(one, hn::Add(excess, set(water.rho0)));
    const auto total = [&](auto push, [[maybe_unused]] auto drag) HWY_ATTR {
      auto sum = hn::Mul(push, push_factor);
      if constexpr (kViscous) sum = hn::MulAdd(drag, drag_factor, sum);
      return hn::Mul(sum, per_density);
    };
    AddLanes(d, total(push_x, drag_x), cluster, ax);
    AddLanes(d, total(push_y, drag_y), cluster, ay);
    around.Store(slope, value_factor, unit, input.support, cluster, water, sums);
    if (refine) refinement.Close(k);
  }
  block.coarse = false;
}

/// Compiled for the combinations of terms that scenes have; the others take one that has more.
template <typename Real, template <class> class Kernel>
void ForcesWith(const PassInput<Real>& input, const WaterInput<Real>& water, ListBlock& block, double* ax, double* ay,
                const WaterSums<Real>& sums) {
  const bool viscous = water.viscosity != 0, artificial = water.artificial != 0;
  if (water.gradient_fall == 0 && !viscous) {
    if (artificial) return Forces<Real, Kernel, false, false, true>(input, water, block, ax, ay, sums);
    return Forces<Real, Kernel, false, false, false>(input, water, block, ax, ay, sums);
  }
  if (artificial) return Forces<Real, Kernel, true, true, true>(input, water, block, ax, ay, sums);
  Forces<Real, Kernel, true, true, false>(input, water, block, ax, ay, sums);
}

}  // namespace

#define SPH_PASSES_OF(Real, Name)                                                                                   \
  void GasDensity##Name(SmoothingKernel kernel, const PassInput<Real>& input, ListBlock& block, Real* density) {    \
    SPH_WITH_KERNEL(kernel, Real, DensityOf, input, block, density)                                                 \
  }                                                                                                                 \
  void GasPressure##Name(SmoothingKernel kernel, const PassInput<Real>& input, const ListBlock& block,              \
                         const Real* term, double* ax, double* ay) {                                                \
    SPH_WITH_KERNEL(kernel, Real, PressureOf, input, block, term, ax, ay)                                           \
  }                                                                                                                 \
  void DensityRates##Name(const PassInput<Real>& input, const WaterInput<Real>& water, const ListBlock& block,      \
                          const DensitySums<Real>& sums) {                                                          \
    SPH_WITH_KERNEL(water.kernel, Real, Rates, input, water, block, sums)                                           \
  }                                                                                                                 \
  void WaterForces##Name(const PassInput<Real>& input, const WaterInput<Real>& water, ListBlock& block, double* ax, \
                         double* ay, const WaterSums<Real>& sums) {                                                 \
    SPH_WITH_KERNEL(water.kernel, Real, ForcesWith, input, water, block, ax, ay, sums)                              \
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
  HWY_EXPORT(GasDensity##Name);                                                                                        \
  HWY_EXPORT(GasPressure##Name);                                                                                       \
  HWY_EXPORT(DensityRates##Name);                                                                                      \
  HWY_EXPORT(WaterForces##Name);                                                                                       \
  template <>                                                                                                          \
  void ComputeGasDensity<Real>(SmoothingKernel kernel, const PassInput<Real>& input, ListBlock& block,                 \
                               Real* density) {                                                                        \
    HWY_DYNAMIC_DISPATCH(GasDensity##Name)(kernel, input, block, density);                                             \
  }                                                                                                                    \
  template <>                                                                                                          \
  void AddGasPressure<Real>(SmoothingKernel kernel, const PassInput<Real>& input, const ListBlock& block,              \
                            const Real* pressure_term, double* ax, double* ay) {                                       \
    HWY_DYNAMIC_DISPATCH(GasPressure##Name)(kernel, input, block, pressure_term, ax, ay);                              \
  }                                                                                                                    \
  template <>                                                                                                          \
  void ComputeDensityRates<Real>(const PassInput<Real>& input, const WaterInput<Real>& water, const ListBlock& block,  \
                                 const DensitySums<Real>& sums) {                                                      \
    HWY_DYNAMIC_DISPATCH(DensityRates##Name)(input, water, block, sums);                                               \
  }                                                                                                                    \
  template <>                                                                                                          \
  void AddWaterForces<Real>(const PassInput<Real>& input, const WaterInput<Real>& water, ListBlock& block, double* ax, \
                            double* ay, const WaterSums<Real>& sums) {                                                 \
    HWY_DYNAMIC_DISPATCH(WaterForces##Name)(input, water, block, ax, ay, sums);                                        \
  }
SPH_DISPATCH(float, Float)
SPH_DISPATCH(double, Double)
#undef SPH_DISPATCH

}  // namespace sph
#endif  // HWY_ONCE
