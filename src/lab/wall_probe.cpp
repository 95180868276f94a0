#include "lab/wall_probe.hpp"

#include <algorithm>

namespace sph {

double PressureAtWall(const ParticleSystemSPH& system, Vec2 point) {
  const Particles& p = system.State();
  const WendlandC2 kernel(0.5 * system.Support());
  const std::vector<double> density = system.Density();
  const std::vector<double> pressure = system.Pressure();
  double sum = 0, filled = 0;
  for (std::size_t j = 0; j < p.Size(); ++j) {
    const double r = Length(p.Position(j) - point);
    if (r >= system.Support()) continue;
    const double share = 2 * p.mass[j] / density[j] * kernel.Value(r);  // with the image's
    sum += share * pressure[j];
    filled += share;
  }
  return sum / std::max(filled, 0.5);
}

}  // namespace sph
