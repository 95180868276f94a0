// What a liquid's images have of their sources, and wall particles of the fluid: behind a wall velocities are turned
// round, and weight goes on.
#include "sph/delta.hpp"

namespace sph {
namespace {

Beyond MirrorOf(ImageOf image) {
  return image == ImageOf::kMirrorLow ? Beyond::kLow : image == ImageOf::kMirrorHigh ? Beyond::kHigh : Beyond::kNone;
}

}  // namespace

template <typename Real>
void Delta::CopyVelocitiesToImages(Arrays<Real>& arrays, const SideVelocities& sides) const {
  const Images& images = neighbours_.AllImages();
  const std::size_t n = particles_.Size();
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    const Vec2 source{static_cast<double>(arrays.vx[i]), static_cast<double>(arrays.vy[i])};
    const Vec2 v = sides.Behind(source, MirrorOf(images.InX()[k]), MirrorOf(images.InY()[k]));
    arrays.vx[n + k] = static_cast<Real>(v.x);
    arrays.vy[n + k] = static_cast<Real>(v.y);
  }
}

template <typename Real>
void Delta::CopyGradientToImages(Arrays<Real>& arrays) const {
  const Images& images = neighbours_.AllImages();
  const std::size_t n = particles_.Size();
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    // The part of the fluid's weight goes on behind a mirror as before it.
    const double weight = density_[i] / (Sound() * Sound());
    const auto turned = [&](ImageOf image, Real value, double gravity) {
      return Mirrored(image) ? static_cast<Real>(2 * weight * gravity) - value : value;
    };
    arrays.gradient_x[n + k] = turned(images.InX()[k], arrays.gradient_x[i], parameters.gravity.x);
    arrays.gradient_y[n + k] = turned(images.InY()[k], arrays.gradient_y[i], parameters.gravity.y);
  }
}

template <typename Real>
void Delta::CopyPressureToImages(Arrays<Real>& arrays) const {
  const Images& images = neighbours_.AllImages();
  const Particles& p = particles_;
  const Ends& ends = neighbours_.CurrentEnds();
  const double per_c2 = 1 / (Sound() * Sound());
  /// From a particle to its image [m]; 0 where that is no mirror's.
  const auto across = [](const AxisEnds& axis, ImageOf image, double at) {
    if (image == ImageOf::kMirrorLow) return 2 * (axis.low - at);
    return image == ImageOf::kMirrorHigh ? 2 * (axis.high - at) : 0.0;
  };
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    const Vec2 apart{across(ends.x, images.InX()[k], p.x[i]), across(ends.y, images.InY()[k], p.y[i])};
    const double weight = density_[i] * Dot(parameters.gravity, apart);  // [Pa]
    arrays.pressure[p.Size() + k] = arrays.pressure[i] + static_cast<Real>(weight);
    arrays.excess[p.Size() + k] = arrays.excess[i] + static_cast<Real>(weight * per_c2);
  }
}

template <typename Real>
void Delta::CopyVectorToImages(std::vector<Real>& x, std::vector<Real>& y) const {
  const Images& images = neighbours_.AllImages();
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    x[particles_.Size() + k] = Mirrored(images.InX()[k]) ? -x[i] : x[i];
    y[particles_.Size() + k] = Mirrored(images.InY()[k]) ? -y[i] : y[i];
  }
}

template <typename Real>
void Delta::SetWallParticles(const FluidArrays<Real>& fluid, Arrays<Real>& arrays, const SideVelocities& sides) {
  const auto sites = neighbours_.AllWallSites().Sites();
  if (sites.empty()) return;
  auto& values = std::get<WallValues<Real>>(wall_values_);
  values.Resize(sites.size());
  const ClusterSet walls = neighbours_.Sets()[2];
  ForEach(neighbours_.WallBlocks(), [&](const ListBlock& block) {
    ComputeWallValues(InputOf(fluid), WaterOf(arrays), walls, block, parameters.gravity, Sound(), values);
  });
  const double rho0 = Rho0(), per_c2 = 1 / (Sound() * Sound());
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const std::size_t j = walls.first + k;
    const auto [column, row, in_x, in_y] = sites[k];
    const double density = rho0 + static_cast<double>(values.excess[k]);
    const Vec2 before{static_cast<double>(values.vx[k]), static_cast<double>(values.vy[k])};
    const Vec2 v = sides.Behind(before, in_x, in_y);
    arrays.volume[j] = static_cast<Real>(parameters.particle_mass / rho0);  // its part of the lattice
    arrays.excess[j] = values.excess[k];
    arrays.pressure[j] = values.pressure[k];
    arrays.wholeness[j] = values.wholeness[k];
    arrays.vx[j] = static_cast<Real>(v.x);
    arrays.vy[j] = static_cast<Real>(v.y);
    arrays.gradient_x[j] = static_cast<Real>(density * per_c2 * parameters.gravity.x);
    arrays.gradient_y[j] = static_cast<Real>(density * per_c2 * parameters.gravity.y);
  }
}

template void Delta::CopyVelocitiesToImages(Arrays<float>&, const SideVelocities&) const;
template void Delta::CopyVelocitiesToImages(Arrays<double>&, const SideVelocities&) const;
template void Delta::CopyGradientToImages(Arrays<float>&) const;
template void Delta::CopyGradientToImages(Arrays<double>&) const;
template void Delta::CopyPressureToImages(Arrays<float>&) const;
template void Delta::CopyPressureToImages(Arrays<double>&) const;
template void Delta::SetWallParticles(const FluidArrays<float>&, Arrays<float>&, const SideVelocities&);
template void Delta::SetWallParticles(const FluidArrays<double>&, Arrays<double>&, const SideVelocities&);
template void Delta::CopyVectorToImages(std::vector<float>&, std::vector<float>&) const;
template void Delta::CopyVectorToImages(std::vector<double>&, std::vector<double>&) const;

}  // namespace sph
