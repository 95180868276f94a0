// Differences of coordinates on vectors; included once for each instruction set.
#if defined(SPH_COORDINATES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SPH_COORDINATES_INL_HPP
#undef SPH_COORDINATES_INL_HPP
#else
#define SPH_COORDINATES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace sph {
namespace HWY_NAMESPACE {

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

}  // namespace HWY_NAMESPACE
}  // namespace sph
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
