// Density and pressure of gas with the kernels of solver delta on vectors, against the sums over all pairs.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "sph/plain_delta_twins.hpp"

namespace sph {
namespace {

template <typename Real>
class GasPasses : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(GasPasses, BothPrecisions);

TYPED_TEST(GasPasses, DensityEqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
        std::vector<TypeParam> density(cloud.Size() + kPadding);
        for (ListBlock& block : found.search.Blocks()) {
          ComputeGasDensity(kernel, found.Input(), block, density.data());
        }
        const auto plain = PlainGasDensity(kernel, found.cloud, kCloudH);
        double greatest = 0;
        for (const PlainSum& sum : plain) greatest = std::max(greatest, sum.value.x);
        for (std::size_t i = 0; i < cloud.Size(); ++i) {
          ASSERT_NEAR(density[i], plain[i].value.x, kTolerance<TypeParam> * greatest) << cloud.name << ", " << i;
        }
      }
    }
  });
}

TYPED_TEST(GasPasses, PressureEqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const SmoothingKernel kernel : kAllKernels) {
        auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
        Random random(7);
        std::vector<double> term(cloud.Size());
        for (double& value : term) value = random.Uniform(-1, 10);
        std::vector<TypeParam> converted(term.begin(), term.end());
        converted.resize(cloud.Size() + kPadding);
        std::vector<double> ax(cloud.Size()), ay(cloud.Size());
        for (const ListBlock& block : found.search.Blocks()) {
          AddGasPressure(kernel, found.Input(), block, converted.data(), ax.data(), ay.data());
        }
        const auto plain = PlainGasPressure(kernel, found.cloud, term, kCloudH);
        double greatest = 0;
        for (const PlainSum& sum : plain) greatest = std::max(greatest, Length(sum.value));
        for (std::size_t i = 0; i < cloud.Size(); ++i) {
          ASSERT_NEAR(ax[i], plain[i].value.x, kTolerance<TypeParam> * greatest) << cloud.name << ", " << i;
          ASSERT_NEAR(ay[i], plain[i].value.y, kTolerance<TypeParam> * greatest) << cloud.name << ", " << i;
        }
      }
    }
  });
}

}  // namespace
}  // namespace sph
