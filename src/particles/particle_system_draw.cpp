// How a ParticleSystem draws itself on a canvas.
#include <cmath>
#include <numbers>

#include "particles/particle_system.hpp"

namespace sph {

void ParticleSystem::Draw(Canvas& canvas) const {
  const Particles& p = particles_;
  std::vector<double> values;
  switch (canvas.WantedColouring()) {
    case Colouring::kBlackDisks:
      break;
    case Colouring::kSpeed:
      values.resize(p.Size());
      for (std::size_t i = 0; i < p.Size(); ++i) values[i] = Length(p.Velocity(i));
      break;
    case Colouring::kPressure:
      values = Pressure();
      break;
    case Colouring::kDensity:
      values = Density();
      break;
  }
  constexpr double kRadiusInSpacings = 0.35;  // disks stay apart where the fluid is at rest
  const auto shown = ShownPositions();
  canvas.DrawDisks(shown ? shown->first : p.x, shown ? shown->second : p.y, kRadiusInSpacings * InitialSpacing(),
                   values);
  if (trouble_) DrawTrouble(canvas);
  constexpr double kFar = 1e6;
  const Box view{-kFar, -kFar, kFar, kFar};
  for (const Wall& wall : parameters.walls) {
    if (const auto segment = VisibleSegment(wall, parameters.walls, view)) canvas.DrawWall(segment->a, segment->b);
  }
}

/// A ring round where the particle was before the step, and the way that it took then; once the system was put back,
/// round where it is now.
void ParticleSystem::DrawTrouble(Canvas& canvas) const {
  constexpr int kSides = 12;
  Vec2 before = trouble_->position - previous_step_ * trouble_->velocity;
  const auto now = std::ranges::find(particles_.id, trouble_->id) - particles_.id.begin();
  if (steps_ < trouble_->step) before = particles_.Position(static_cast<std::size_t>(now));
  const double radius = 2 * InitialSpacing();
  const auto corner = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / kSides;
    return before + radius * Vec2{std::cos(angle), std::sin(angle)};
  };
  for (int k = 0; k < kSides; ++k) canvas.DrawWall(corner(k), corner(k + 1));
  canvas.DrawWall(before, trouble_->position);
}

}  // namespace sph
