// A cloud with what the liquid's passes read, and the passes run on it.
#pragma once

#include "sph/plain_delta_twins.hpp"

namespace sph {

template <typename Real>
struct WaterSetting {
  explicit WaterSetting(const Cloud& given) : found(FindNeighbours<Real>(given, 2 * kCloudH)), cloud(found.cloud) {
    for (auto* values :
         {&water.excess, &water.pressure, &water.gradient_x, &water.gradient_y, &water.wholeness, &water.strain, &rate,
          &strain, &ax, &ay, &gradient_x, &gradient_y, &wholeness, &shift_x, &shift_y, &concentration}) {
      values->assign(cloud.Size(), 0);
    }
  }
  WaterSetting(const WaterSetting&) = delete;  // `cloud` refers to `found`

  void ComputeRates() {
    const Converted arrays(*this);
    std::vector<Real> out[2];
    for (auto& values : out) values.resize(cloud.Size() + kPadding);
    const DensitySums<Real> sums{out[0].data(), out[1].data()};
    for (const ListBlock& block : found.search.Blocks()) {
      ComputeDensityRates(found.Input(), arrays.Input(water), block, sums);
    }
    rate.assign(out[0].begin(), out[0].end() - kPadding);
    strain.assign(out[1].begin(), out[1].end() - kPadding);
  }

  /// Accelerations anew, and the sums.
  void ComputeForces() {
    const Converted arrays(*this);
    std::vector<Real> out[6];
    for (auto& values : out) values.resize(cloud.Size() + kPadding);
    const WaterSums<Real> sums{out[0].data(), out[1].data(), out[2].data(),
                               out[3].data(), out[4].data(), out[5].data()};
    ax.assign(cloud.Size(), 0);
    ay.assign(cloud.Size(), 0);
    for (ListBlock& block : found.search.Blocks()) {
      AddWaterForces(found.Input(), arrays.Input(water), block, ax.data(), ay.data(), sums);
    }
    std::vector<double>* const to[6] = {&gradient_x, &gradient_y, &wholeness, &shift_x, &shift_y, &concentration};
    for (int k = 0; k < 6; ++k) to[k]->assign(out[k].begin(), out[k].end() - kPadding);
  }

  Neighbourhood<Real> found;
  Cloud& cloud;  ///< in the order of its clusters, which all arrays have
  PlainWater water;
  std::vector<double> rate, strain, ax, ay, gradient_x, gradient_y, wholeness, shift_x, shift_y, concentration;

 private:
  struct Converted {
    explicit Converted(const WaterSetting& s) {
      std::vector<double> volumes;
      for (std::size_t i = 0; i < s.cloud.Size(); ++i) volumes.push_back(s.cloud.mass[i] / s.water.Density(i));
      Convert(volumes, volume);
      Convert(s.water.excess, excess);
      Convert(s.water.pressure, pressure);
      Convert(s.cloud.vx, vx);
      Convert(s.cloud.vy, vy);
      Convert(s.water.gradient_x, gradient_x);
      Convert(s.water.gradient_y, gradient_y);
      Convert(s.water.wholeness, wholeness);
      Convert(s.water.strain, strain);
    }
    static void Convert(const std::vector<double>& from, std::vector<Real>& to) {
      to.assign(from.begin(), from.end());
      to.resize(from.size() + kPadding);
    }
    WaterInput<Real> Input(const PlainWater& given) const {
      return {.kernel = given.kernel,
              .volume = volume.data(),
              .excess = excess.data(),
              .pressure = pressure.data(),
              .vx = vx.data(),
              .vy = vy.data(),
              .gradient_x = gradient_x.data(),
              .gradient_y = gradient_y.data(),
              .wholeness = wholeness.data(),
              .strain = strain.data(),
              .sound = given.sound,
              .rho0 = given.rho0,
              .diffusion = given.diffusion,
              .viscosity = given.viscosity,
              .artificial = given.artificial,
              .spacing = given.spacing,
              .variance = given.variance,
              .gradient_flat = given.gradient_flat,
              .gradient_fall = given.gradient_fall,
              .tensile_control = given.tensile_control};
    }
    std::vector<Real> volume, excess, pressure, vx, vy, gradient_x, gradient_y, wholeness, strain;
  };
};

}  // namespace sph
