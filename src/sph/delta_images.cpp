// What a liquid's images have of their sources, and wall particles of the fluid: behind a wall velocities are turned
// round, and weight goes on.
#include <algorithm>

#include "sph/delta.hpp"

namespace sph {
namespace {

/// Velocity of the wall that bounds the fluid on this side [m/s].
Vec2 WallVelocity(std::span<const Wall> walls, bool low, bool vertical) {
  const FluidSide side =
      vertical ? (low ? FluidSide::kRight : FluidSide::kLeft) : (low ? FluidSide::kAbove : FluidSide::kBelow);
  const auto found = std::ranges::find(walls, side, &Wall::fluid);
  if (found == walls.end()) return {};
  return vertical ? Vec2{found->velocity, found->slide} : Vec2{found->slide, found->velocity};
}

}  // namespace

template <typename Real>
void Delta::CopyVelocitiesToImages(Arrays<Real>& arrays) const {
  const Images& images = neighbours_.AllImages();
  const std::size_t n = particles_.Size();
  const Ends& ends = neighbours_.CurrentEnds();
  const Particles& p = particles_;
  const bool sticks = parameters.wall.no_slip;
  const double mu = parameters_sph.viscosity;
  const double c2 = Sound() * Sound();
  // A velocity along the wall. Turned round alone, its profile would have a kink in its second derivative there, which
  // is -(rho g - grad p)/mu: nothing accelerates at the wall.
  const auto along = [&](double v, double slide, std::size_t i, double depth, double gravity, double gradient) {
    if (!sticks) return v;
    const double turned = 2 * slide - v;
    return mu > 0 ? turned - (density_[i] * gravity - c2 * gradient) / mu * depth * depth : turned;
  };
  const auto depth = [](const AxisEnds& axis, ImageOf image, double at) {
    return image == ImageOf::kMirrorLow ? at - axis.low : axis.high - at;
  };
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    double vx = static_cast<double>(arrays.vx[i]), vy = static_cast<double>(arrays.vy[i]);
    if (const ImageOf image = images.InX()[k]; Mirrored(image)) {
      const Vec2 wall = WallVelocity(parameters.walls, image == ImageOf::kMirrorLow, true);
      vx = 2 * wall.x - vx;
      vy = along(vy, wall.y, i, depth(ends.x, image, p.x[i]), parameters.gravity.y,
                 static_cast<double>(arrays.gradient_y[i]));
    }
    if (const ImageOf image = images.InY()[k]; Mirrored(image)) {
      const Vec2 wall = WallVelocity(parameters.walls, image == ImageOf::kMirrorLow, false);
      vy = 2 * wall.y - vy;
      vx = along(vx, wall.x, i, depth(ends.y, image, p.y[i]), parameters.gravity.x,
                 static_cast<double>(arrays.gradient_x[i]));
    }
    arrays.vx[n + k] = static_cast<Real>(vx);
    arrays.vy[n + k] = static_cast<Real>(vy);
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
void Delta::SetWallParticles(const FluidArrays<Real>& fluid, Arrays<Real>& arrays) {
  const auto sites = neighbours_.AllWallSites().Sites();
  if (sites.empty()) return;
  auto& values = std::get<WallValues<Real>>(wall_values_);
  values.Resize(sites.size());
  const ClusterSet walls = neighbours_.Sets()[2];
  ForEach(neighbours_.WallBlocks(), [&](const ListBlock& block) {
    ComputeWallValues(InputOf(fluid), WaterOf(arrays), walls, block, parameters.gravity, Sound(), values);
  });
  const double rho0 = Rho0(), per_c2 = 1 / (Sound() * Sound());
  const bool sticks = parameters.wall.no_slip;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const std::size_t j = walls.first + k;
    const auto [column, row, in_x, in_y] = sites[k];
    const double density = rho0 + static_cast<double>(values.excess[k]);
    double vx = static_cast<double>(values.vx[k]), vy = static_cast<double>(values.vy[k]);
    if (in_x != Beyond::kNone) {
      const Vec2 wall = WallVelocity(parameters.walls, in_x == Beyond::kLow, true);
      vx = 2 * wall.x - vx;
      if (sticks && in_y == Beyond::kNone) vy = 2 * wall.y - vy;
    }
    if (in_y != Beyond::kNone) {
      const Vec2 wall = WallVelocity(parameters.walls, in_y == Beyond::kLow, false);
      vy = 2 * wall.y - vy;
      if (sticks && in_x == Beyond::kNone) vx = 2 * wall.x - vx;
    }
    arrays.volume[j] = static_cast<Real>(parameters.particle_mass / rho0);  // its part of the lattice
    arrays.excess[j] = values.excess[k];
    arrays.pressure[j] = values.pressure[k];
    arrays.wholeness[j] = values.wholeness[k];
    arrays.vx[j] = static_cast<Real>(vx);
    arrays.vy[j] = static_cast<Real>(vy);
    arrays.gradient_x[j] = static_cast<Real>(density * per_c2 * parameters.gravity.x);
    arrays.gradient_y[j] = static_cast<Real>(density * per_c2 * parameters.gravity.y);
  }
}

template void Delta::CopyVelocitiesToImages(Arrays<float>&) const;
template void Delta::CopyVelocitiesToImages(Arrays<double>&) const;
template void Delta::CopyGradientToImages(Arrays<float>&) const;
template void Delta::CopyGradientToImages(Arrays<double>&) const;
template void Delta::CopyPressureToImages(Arrays<float>&) const;
template void Delta::CopyPressureToImages(Arrays<double>&) const;
template void Delta::SetWallParticles(const FluidArrays<float>&, Arrays<float>&);
template void Delta::SetWallParticles(const FluidArrays<double>&, Arrays<double>&);
template void Delta::CopyVectorToImages(std::vector<float>&, std::vector<float>&) const;
template void Delta::CopyVectorToImages(std::vector<double>&, std::vector<double>&) const;

}  // namespace sph
