#include "sph/side_velocities.hpp"

namespace sph {

SideVelocities::Side SideVelocities::NormalOf(const Wall* wall) {
  if (wall == nullptr) return {};
  return wall->Vertical() ? Side{wall->velocity, {}} : Side{{}, wall->velocity};
}

SideVelocities SideVelocities::ForDensity(std::span<const Wall> walls, double seconds_ago) {
  const BoundingWalls bounding(walls, seconds_ago);
  SideVelocities velocities;
  for (std::size_t k = 0; k < velocities.sides_.size(); ++k) velocities.sides_[k] = NormalOf(bounding.All()[k]);
  return velocities;
}

SideVelocities SideVelocities::ForForces(std::span<const Wall> walls, const WallParameters& parameters, double time) {
  SideVelocities velocities = ForDensity(walls, 0);
  for (const Wall* wall : BoundingWalls(walls).All()) {
    if (wall == nullptr || !Sticks(*wall, parameters)) continue;
    Side& side = velocities.sides_[static_cast<std::size_t>(wall->fluid)];
    (wall->Vertical() ? side.vy : side.vx) = wall->tangential.At(time);
  }
  return velocities;
}

Vec2 SideVelocities::Behind(Vec2 velocity, Beyond in_x, Beyond in_y) const {
  const auto side = [&](Beyond beyond, FluidSide of_low, FluidSide of_high) {
    if (beyond == Beyond::kNone) return Side{};
    return sides_[static_cast<std::size_t>(beyond == Beyond::kLow ? of_low : of_high)];
  };
  const Side beyond_x = side(in_x, FluidSide::kRight, FluidSide::kLeft);
  const Side beyond_y = side(in_y, FluidSide::kAbove, FluidSide::kBelow);
  const auto behind = [](double v, const std::optional<double>& one, const std::optional<double>& other) {
    return one.has_value() == other.has_value() ? v : 2 * (one ? *one : *other) - v;
  };
  return {behind(velocity.x, beyond_x.vx, beyond_y.vx), behind(velocity.y, beyond_x.vy, beyond_y.vy)};
}

}  // namespace sph
