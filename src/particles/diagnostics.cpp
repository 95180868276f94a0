#include "particles/diagnostics.hpp"

#include <algorithm>
#include <limits>

#include "base/hash.hpp"

namespace sph {
namespace {

std::vector<std::size_t> OrderOfCreation(const Particles& p) {
  std::vector<std::size_t> index_of_id(p.Size());
  for (std::size_t i = 0; i < p.Size(); ++i) index_of_id[p.id[i]] = i;
  return index_of_id;
}

bool BeyondAWall(const ParticleSystem& system, Vec2 position) {
  const auto& walls = system.parameters.walls;
  const double spacing = system.InitialSpacing();
  return std::any_of(walls.begin(), walls.end(), [&](const Wall& wall) { return !(wall.Depth(position) <= spacing); });
}

}  // namespace

Diagnostics Diagnose(const ParticleSystem& system) {
  const Particles& p = system.State();
  const Parameters& parameters = system.parameters;
  Diagnostics d;
  Hash hash;
  hash.Add(system.Time());
  double mass = 0;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  d.bounds = {kFar, kFar, -kFar, -kFar};
  for (const std::size_t i : OrderOfCreation(p)) {
    const Vec2 x = p.Position(i);
    const Vec2 v = p.Velocity(i);
    const double m = p.mass[i];
    mass += m;
    d.kinetic_energy += 0.5 * m * Dot(v, v);
    d.potential_energy += m * (0.5 * parameters.central_force * Dot(x, x) - Dot(parameters.gravity, x));
    d.momentum = d.momentum + m * v;
    d.angular_momentum += m * (x.x * v.y - x.y * v.x);
    d.centre_of_mass = d.centre_of_mass + m * x;
    d.max_speed = std::max(d.max_speed, Length(v));
    d.bounds = {std::min(d.bounds.x0, x.x), std::min(d.bounds.y0, x.y), std::max(d.bounds.x1, x.x),
                std::max(d.bounds.y1, x.y)};
    d.outside += BeyondAWall(system, x) ? 1 : 0;
    for (const double component : {x.x, x.y, p.vx_prev[i], p.vy_prev[i]}) hash.Add(component);
  }
  if (p.Size() == 0) {
    d.bounds = {};
  } else {
    d.centre_of_mass = (1 / mass) * d.centre_of_mass;
  }
  d.internal_energy = system.InternalEnergy();
  if (const auto density = system.Density(); !density.empty()) {
    const auto [least, greatest] = std::minmax_element(density.begin(), density.end());
    double sum = 0;
    for (const double rho : density) sum += rho;
    d.density = {*least, sum / static_cast<double>(density.size()), *greatest};
  }
  d.deepest = system.DeepestPenetration() / system.InitialSpacing();
  d.state_hash = hash.Value();
  return d;
}

}  // namespace sph
