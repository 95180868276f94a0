// The front of the water column against experiments. They are later than an ideal fluid: the gate takes time, and the
// floor is rough. So the delay is told, and how well the rest agrees.
#include <algorithm>
#include <cmath>

#include "lab/reference_data.hpp"
#include "lab/series.hpp"
#include "lab/verification.hpp"

namespace sph {
namespace {

constexpr double kNearTheWall = 3.95;  // widths; the far wall is four away
constexpr double kLatest = 4;          // T at which the front is there long since

/// (T, front over a) up to the far wall; times are in units of `unit`.
PointSeries MeasuredFront(const std::string& name, double unit) {
  PointSeries points = ReadReference(name);
  std::erase_if(points, [](Vec2 point) { return point.y > kNearTheWall; });
  for (Vec2& point : points) point.x /= unit;
  return points;
}

}  // namespace

/// The front's place over a against T = t sqrt(2g/a).
std::vector<Verdict> MeasureMeasuredFront(ParticleSystemSPH& system) {
  constexpr double kLongestDelay = 0.6;
  const double width = system.parameters.fluid.region.box.Width();
  const double unit = std::sqrt(0.5 * width / -system.parameters.gravity.y);  // [s]
  PointSeries front;
  const auto note = [&] {
    const double foremost = std::ranges::max(system.State().x) + 0.5 * system.InitialSpacing();
    front.push_back({system.Time() / unit, foremost / width});
  };
  note();
  while (front.back().y < kNearTheWall && front.back().x < kLatest && !system.Trouble()) {
    system.Step();
    note();
  }
  std::vector<Verdict> verdicts;
  const auto add = [&](const std::string& who, const PointSeries& measured) {
    const bool broken = system.Trouble().has_value();
    const double delay = BestDelay(front, measured, kLongestDelay);
    verdicts.push_back({"front, delayed, RMS over a, " + who, broken ? kBroken : Difference(front, measured, delay),
                        0.06, "measured; elsewhere 0.01 to 0.06"});
    verdicts.push_back({"that delay in T, " + who, broken ? kBroken : delay, 0.29,
                        "the gate's, and friction's; elsewhere 0.22 to 0.29"});
  };
  add("Martin & Moyce", MeasuredFront("martin_moyce1952_a2.25in_n2eq2", 1));
  // In seconds, for a column of one metre.
  add("Koshizuka & Oka", MeasuredFront("koshizuka_oka1996_front_measured", std::sqrt(0.5 / 9.81)));
  return verdicts;
}

}  // namespace sph
