#include "particles/walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace sph {

double TangentialVelocity::At(double time) const {
  return mean + amplitude * std::sin(2 * std::numbers::pi * frequency * time + phase);
}

Vec2 Wall::Normal() const {
  switch (fluid) {
    case FluidSide::kLeft:
      return {-1, 0};
    case FluidSide::kRight:
      return {1, 0};
    case FluidSide::kBelow:
      return {0, -1};
    case FluidSide::kAbove:
      return {0, 1};
  }
  return {0, 0};
}

double Wall::Depth(Vec2 point) const {
  const double coordinate = Vertical() ? point.x : point.y;
  const bool fluid_at_larger = fluid == FluidSide::kRight || fluid == FluidSide::kAbove;
  return fluid_at_larger ? at - coordinate : coordinate - at;
}

bool Sticks(const Wall& wall, const WallParameters& parameters) {
  return parameters.SeenByFluid() && wall.no_slip.value_or(parameters.no_slip);
}

Penetration PenetrationAfter(const WallParameters& wall, double speed, double seconds) {
  // d = speed e^(-c t/2) s(t), with s = sin(w t)/w, t or sinh(w t)/w as w^2 = K - c^2/4 is positive, 0 or negative. In
  // the last case as two exponentials: where the damping is strong, sinh alone is beyond any number.
  const double half_damping = 0.5 * wall.damping;
  const double w2 = wall.stiffness - half_damping * half_damping;
  const double w = std::sqrt(std::abs(w2));
  if (w2 < 0) {
    const double slow = std::exp((w - half_damping) * seconds), fast = std::exp(-(w + half_damping) * seconds);
    const double depth = speed * (slow - fast) / (2 * w);
    return {depth, 0.5 * speed * (slow + fast) - half_damping * depth};
  }
  const double decay = speed * std::exp(-half_damping * seconds);
  const double s = w == 0 ? seconds : std::sin(w * seconds) / w;
  return {decay * s, decay * (std::cos(w * seconds) - half_damping * s)};
}

void MoveWalls(std::span<Wall> walls, double dt) {
  for (Wall& wall : walls) {
    if (wall.velocity == 0) continue;
    const double wanted = wall.at + wall.velocity * dt;
    wall.at = std::clamp(wanted, wall.lowest, wall.highest);
    if (wall.at != wanted) wall.velocity = 0;
  }
}

BoundingWalls::BoundingWalls(std::span<const Wall> walls, double seconds_ago) {
  const auto place = [seconds_ago](const Wall& wall) {
    const double into_fluid = wall.Normal().x + wall.Normal().y;
    return std::tuple{into_fluid * (wall.at - seconds_ago * wall.velocity), into_fluid * wall.velocity};
  };
  for (const Wall& wall : walls) {
    const Wall*& bounds = all_[static_cast<std::size_t>(wall.fluid)];
    if (bounds == nullptr || place(wall) > place(*bounds) ||
        (place(wall) == place(*bounds) && wall.name < bounds->name)) {
      bounds = &wall;
    }
  }
}

Box LegalRegion(std::span<const Wall> walls, double seconds_ago) {
  const BoundingWalls bounding(walls, seconds_ago);
  const auto at = [&](FluidSide fluid, double far) {
    const Wall* wall = bounding.Of(fluid);
    return wall == nullptr ? far : wall->at - seconds_ago * wall->velocity;
  };
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {at(FluidSide::kRight, -kFar), at(FluidSide::kAbove, -kFar), at(FluidSide::kLeft, kFar),
          at(FluidSide::kBelow, kFar)};
}

Wall* FindWall(std::span<Wall> walls, std::string_view name) {
  const auto found = std::find_if(walls.begin(), walls.end(), [&](const Wall& wall) { return wall.name == name; });
  return found == walls.end() ? nullptr : &*found;
}

std::optional<Segment> VisibleSegment(const Wall& wall, std::span<const Wall> walls, const Box& view) {
  const Box legal = LegalRegion(walls);
  const double ends[2] = {wall.Vertical() ? std::max(legal.y0, view.y0) : std::max(legal.x0, view.x0),
                          wall.Vertical() ? std::min(legal.y1, view.y1) : std::min(legal.x1, view.x1)};
  const bool covered =
      wall.Vertical() ? (wall.at < legal.x0 || wall.at > legal.x1) : (wall.at < legal.y0 || wall.at > legal.y1);
  if (covered || ends[0] >= ends[1]) return std::nullopt;
  if (wall.Vertical()) return Segment{{wall.at, ends[0]}, {wall.at, ends[1]}};
  return Segment{{ends[0], wall.at}, {ends[1], wall.at}};
}

}  // namespace sph
