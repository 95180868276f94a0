#include "lab/fill_gauges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sph/kernels.hpp"

namespace sph {
namespace {

/// Points sorted by x, to find those near a place.
class PointsByX {
 public:
  explicit PointsByX(std::vector<Vec2> points) : points_(std::move(points)) {
    std::ranges::sort(points_, {}, [](Vec2 point) { return std::pair(point.x, point.y); });
  }
  explicit PointsByX(const Particles& particles) : PointsByX(PlacesOf(particles)) {}

  /// Calls visit(distance) for every point nearer than `reach`.
  template <typename Visit>
  void ForEachNear(Vec2 place, double reach, Visit visit) const {
    auto at = std::ranges::lower_bound(points_, place.x - reach, {}, &Vec2::x);
    for (; at != points_.end() && at->x < place.x + reach; ++at) {
      const double distance = Length(*at - place);
      if (distance < reach) visit(distance);
    }
  }
  static std::vector<Vec2> PlacesOf(const Particles& particles) {
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < particles.Size(); ++i) places.push_back(particles.Position(i));
    return places;
  }
  const std::vector<Vec2>& Points() const { return points_; }

 private:
  std::vector<Vec2> points_;
};

/// The particles, and what is seen of them behind walls and floor.
std::vector<Vec2> WithReflections(const Particles& particles, const Trough& trough, double reach) {
  std::vector<Vec2> places = PointsByX::PlacesOf(particles);
  const auto reflect = [&](double distance_of_side, auto mirrored) {
    const std::size_t n = places.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto [distance, image] = mirrored(places[i]);
      if (distance < distance_of_side) places.push_back(image);
    }
  };
  reflect(reach, [&](Vec2 at) { return std::pair(at.x - trough.left, Vec2{2 * trough.left - at.x, at.y}); });
  reflect(reach, [&](Vec2 at) { return std::pair(trough.right - at.x, Vec2{2 * trough.right - at.x, at.y}); });
  reflect(reach, [&](Vec2 at) { return std::pair(at.y - trough.floor, Vec2{at.x, 2 * trough.floor - at.y}); });
  return places;
}

}  // namespace

double FilledHeight(const Particles& particles, const Trough& trough, double spacing) {
  constexpr double kSmoothingLength = 1.5, kStep = 0.25, kAccuracy = 1e-6;  // in spacings
  const QuinticSpline kernel(kSmoothingLength * spacing);
  const double reach = QuinticSpline::kSupport * kSmoothingLength * spacing;
  const PointsByX points(WithReflections(particles, trough, reach));
  const auto filled = [&](Vec2 place) {
    double sum = 0;
    points.ForEachNear(place, reach, [&](double distance) { sum += spacing * spacing * kernel.Value(distance); });
    return sum >= 0.5;
  };
  const double top = std::ranges::max(particles.y) + spacing;
  const auto columns = static_cast<int>(std::ceil((trough.right - trough.left) / spacing));
  double sum = 0;
  for (int column = 0; column < columns; ++column) {
    const double x = trough.left + (column + 0.5) / columns * (trough.right - trough.left);
    double dry = top, wet = top;
    while (wet > trough.floor && !filled({x, wet})) {
      dry = wet;
      wet -= kStep * spacing;
    }
    while (dry - wet > kAccuracy * spacing) (filled({x, 0.5 * (dry + wet)}) ? wet : dry) = 0.5 * (dry + wet);
    sum += std::max(0.0, wet - trough.floor);
  }
  return sum / columns;
}

double MeanConcentration(const ParticleSystemSPH& system) {
  const Particles& particles = system.State();
  const double reach = system.Support();
  const WendlandC2 kernel(0.5 * reach);
  const double area = particles.mass.front() / ReferenceDensity(system.parameters_sph.equation_of_state);
  const Box legal = LegalRegion(system.parameters.walls);
  const PointsByX points(particles);
  double sum = 0;
  std::size_t inside = 0;
  for (const Vec2 at : points.Points()) {
    const double to_walls = std::min({at.x - legal.x0, legal.x1 - at.x, at.y - legal.y0, legal.y1 - at.y});
    if (!(to_walls > reach)) continue;
    points.ForEachNear(at, reach, [&](double distance) { sum += area * kernel.Value(distance); });
    ++inside;
  }
  return inside > 0 ? sum / static_cast<double>(inside) : std::numeric_limits<double>::quiet_NaN();
}

double PairedShare(const Particles& particles, double distance) {
  const PointsByX points(particles);
  std::size_t paired = 0;
  for (const Vec2 at : points.Points()) {
    int near = 0;
    points.ForEachNear(at, distance, [&](double) { ++near; });
    paired += near > 1;  // itself is one
  }
  return static_cast<double>(paired) / static_cast<double>(particles.Size());
}

}  // namespace sph
