#include "sph/kernel_properties.hpp"

#include <cmath>
#include <numbers>

namespace sph {
namespace {

constexpr KernelProperties kProperties[] = {
    {"Wendland C2", 5.0 / 72, 3.669902912621359, 9.611650485436893, 1.76, 1.36, 1.25, 0.2887, 1.07, 6.05, 0.9},
    {"Wendland C4", 7.0 / 132, 3.507874015748029, 11.82283464566928, 1.53, 1.19, 1.09, 0.2227, 1.3, 8.9, 0.66},
    {"quintic spline", 2771.0 / 51624, 3.502469008548194, 11.655310366049438, 1.54, 1.2, 1.09, 0.2297, 1.3, 8.75,
     0.66}};

/// The sums of one lattice, whose sites are at a (column + row b, row c) and have unit area each.
template <typename Kernel>
LatticeSums SumsOn(const Kernel& kernel, const KernelProperties& properties, double reach, double a, double b,
                   double c) {
  LatticeSums sums{0, 0, 0};
  const int rows = static_cast<int>(reach / (a * c)) + 1, columns = static_cast<int>(reach / a) + 1;
  for (int row = -rows; row <= rows; ++row) {
    for (int column = -columns - rows; column <= columns + rows; ++column) {
      const double r = a * std::hypot(column + row * b, row * c);
      if (r >= reach) continue;
      const double s2 = r * r / (reach * reach);
      sums.concentration += kernel.Value(r);
      const double second = -0.5 * kernel.Gradient(r) * r * r;
      sums.second_order += second;
      sums.fourth_order += second * (properties.flat - properties.fall * s2);
    }
  }
  return sums;
}

template <typename Kernel>
LatticeSums MeanSums(const KernelProperties& properties, double reach) {
  const Kernel kernel(reach / Kernel::kSupport);
  const LatticeSums square = SumsOn(kernel, properties, reach, 1, 0, 1);
  const double pitch = std::sqrt(2 / std::numbers::sqrt3);
  const LatticeSums hexagonal = SumsOn(kernel, properties, reach, pitch, 0.5, 0.5 * std::numbers::sqrt3);
  return {0.5 * (square.concentration + hexagonal.concentration), 0.5 * (square.second_order + hexagonal.second_order),
          0.5 * (square.fourth_order + hexagonal.fourth_order)};
}

}  // namespace

const KernelProperties& PropertiesOf(SmoothingKernel kernel) { return kProperties[static_cast<std::size_t>(kernel)]; }

LatticeSums SumsOnLattices(SmoothingKernel kernel, double reach) {
  constexpr double kLeast = 2, kMost = 20;  // spacings: with fewer there is no gradient, with more the sums are 1
  if (!(reach >= kLeast && reach <= kMost)) return {};
  const KernelProperties& properties = PropertiesOf(kernel);
  switch (kernel) {
    case SmoothingKernel::kWendlandC2:
      return MeanSums<WendlandC2>(properties, reach);
    case SmoothingKernel::kWendlandC4:
      return MeanSums<WendlandC4>(properties, reach);
    case SmoothingKernel::kQuintic:
      return MeanSums<QuinticSpline>(properties, reach);
  }
  return {};
}

}  // namespace sph
