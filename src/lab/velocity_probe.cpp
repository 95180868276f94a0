#include "lab/velocity_probe.hpp"

#include "sph/kernels.hpp"

namespace sph {

/// The fit is sum_j w_j u_j, w_j = W_j (c . (1, dx_j, dy_j)) with M c = (1, 0, 0), M = sum_j W_j (1, dx, dy)(1, dx,
/// dy)^T: the first column of M's inverse, by its cofactors.
Vec2 VelocityAt(const Particles& particles, Vec2 at, double reach) {
  const WendlandC2 kernel(0.5 * reach);
  double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  Vec2 u, ux, uy;
  for (std::size_t j = 0; j < particles.Size(); ++j) {
    const Vec2 d = (1 / reach) * (particles.Position(j) - at);
    if (Dot(d, d) >= 1) continue;
    const double weight = kernel.Value(reach * Length(d));
    const Vec2 velocity = weight * particles.Velocity(j);
    w += weight, x += weight * d.x, y += weight * d.y;
    xx += weight * d.x * d.x, xy += weight * d.x * d.y, yy += weight * d.y * d.y;
    u = u + velocity, ux = ux + d.x * velocity, uy = uy + d.y * velocity;
  }
  const double c = xx * yy - xy * xy, cx = xy * y - x * yy, cy = x * xy - xx * y;
  return (1 / (w * c + x * cx + y * cy)) * (c * u + cx * ux + cy * uy);
}

}  // namespace sph
