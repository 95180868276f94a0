// The flow in a square cavity that a sliding lid drives, against the profiles of Ghia, Ghia & Shin, J. Comput. Phys. 48
// (1982) 387.
#include <algorithm>
#include <cmath>

#include "lab/fill_gauges.hpp"
#include "lab/reference_data.hpp"
#include "lab/velocity_probe.hpp"
#include "lab/verification.hpp"

namespace sph {
namespace {

constexpr int kLooks = 11;  // at the steady flow, of which the mean is taken

/// Root mean square of differences, and the greatest.
struct Differences {
  double squares = 0, greatest = 0;
  int points = 0;

  void Add(double difference) {
    squares += difference * difference;
    greatest = std::max(greatest, std::abs(difference));
    ++points;
  }
  double Rms() const { return std::sqrt(squares / points); }
};

/// Points between the walls along a mid-line, (place, velocity across the other axis), in sides and speeds of the lid.
std::vector<Vec2> Profile(const std::string& name) {
  std::vector<Vec2> points = ReadReference(name);
  std::erase_if(points, [](Vec2 point) { return point.x <= 0 || point.x >= 1; });
  return points;
}

/// The steady flow is there long before: the slowest mode of the square decays as exp(-52.3 nu t/L^2) [E. Leriche &
/// G. Labrosse, J. Comput. Phys. 200 (2004) 489], by exp(-13) until 25.
std::vector<double> TimesOfCavity(const ParticleSystemSPH&) {
  std::vector<double> times(kLooks);
  for (int look = 0; look < kLooks; ++look) times[look] = 25 + 0.5 * look;
  return times;
}

/// The mean over the snapshots of a component at the points, against what it should be.
template <typename Place, typename Component>
Differences Compare(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots,
                    const std::vector<Vec2>& points, Place place, Component component) {
  const Box box = flow.parameters.fluid.region.box;
  Differences differences;
  for (const Vec2 point : points) {
    const Vec2 at = Vec2{box.x0, box.y0} + box.Width() * place(point.x);
    double mean = 0;
    for (const FlowSnapshot& snapshot : snapshots) {
      mean += component(VelocityAt(snapshot.particles, at, flow.Support())) / static_cast<double>(snapshots.size());
    }
    differences.Add(mean - point.y);
  }
  return differences;
}

std::vector<Verdict> JudgeCavity(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots) {
  const auto u = Compare(
      flow, snapshots, Profile("ghia1982_u_x0.5"),
      [](double y) {
        return Vec2{0.5, y};
      },
      [](Vec2 velocity) { return velocity.x; });
  const auto v = Compare(
      flow, snapshots, Profile("ghia1982_v_y0.5"),
      [](double x) {
        return Vec2{x, 0.5};
      },
      [](Vec2 velocity) { return velocity.y; });
  const bool none = snapshots.empty();
  const auto row = [&](const char* metric, double value, double bar) {
    return Verdict{.metric = metric,
                   .value = none ? kBroken : value,
                   .bar = bar,
                   .reference = "Ghia 1982, Re = 100, 129 x 129; in speeds of the lid",
                   .promise = {1, "the velocity jumps where the lid meets walls at rest"}};
  };
  return {row("u on the vertical mid-line, RMS error", u.Rms(), 0.009),
          row("v on the horizontal mid-line, RMS error", v.Rms(), 0.009),
          row("u on the vertical mid-line, greatest error", u.greatest, 0.027),
          row("v on the horizontal mid-line, greatest error", v.greatest, 0.027)};
}

}  // namespace

const Judgement kCavity{&TimesOfCavity, &JudgeCavity};

std::vector<Verdict> MeasureCavity(ParticleSystemSPH& system) { return Judge(kCavity, system); }

std::vector<Verdict> MeasureCavityDrift(ParticleSystemSPH& system) {
  const double start = MeanConcentration(system);
  AdvanceTo(system, 100);
  return {{.metric = "mean of sum V W inside, change until t = 100, relative",
           .value = system.Trouble() ? kBroken : MeanConcentration(system) / start - 1,
           .bar = 0.002,
           .reference = "constant: the cavity stays full",
           .kind = MetricKind::kBounded}};
}

}  // namespace sph
