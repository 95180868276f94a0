// Density and pressure of gas with Wendland kernels on vectors, against the sums over all pairs.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "sph/plain_delta_twins.hpp"

namespace sph {
namespace {

constexpr WendlandKernel kBoth[] = {WendlandKernel::kC2, WendlandKernel::kC4};

template <typename Real>
class WendlandPasses : public testing::Test {};
using BothPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(WendlandPasses, BothPrecisions);

TYPED_TEST(WendlandPasses, DensityEqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const WendlandKernel kernel : kBoth) {
        auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
        std::vector<TypeParam> density(cloud.Size() + kPadding);
        for (ListBlock& block : found.search.Blocks()) {
          ComputeWendlandDensity(kernel, found.Input(), block, density.data());
        }
        const auto plain = PlainWendlandDensity(kernel, found.cloud, kCloudH);
        double greatest = 0;
        for (const PlainSum& sum : plain) greatest = std::max(greatest, sum.value.x);
        for (std::size_t i = 0; i < cloud.Size(); ++i) {
          ASSERT_NEAR(density[i], plain[i].value.x, kTolerance<TypeParam> * greatest) << cloud.name << ", " << i;
        }
      }
    }
  });
}

TYPED_TEST(WendlandPasses, PressureEqualsTheSumOverAllPairs) {
  WithEveryInstructionSet([] {
    for (const Cloud& cloud : AllClouds()) {
      for (const WendlandKernel kernel : kBoth) {
        auto found = FindNeighbours<TypeParam>(cloud, 2 * kCloudH);
        Random random(7);
        std::vector<double> term(cloud.Size());
        for (double& value : term) value = random.Uniform(-1, 10);
        std::vector<TypeParam> converted(term.begin(), term.end());
        converted.resize(cloud.Size() + kPadding);
        std::vector<double> ax(cloud.Size()), ay(cloud.Size());
        for (const ListBlock& block : found.search.Blocks()) {
          AddWendlandPressure(kernel, found.Input(), block, converted.data(), ax.data(), ay.data());
        }
        const auto plain = PlainWendlandPressure(kernel, found.cloud, term, kCloudH);
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
