// The front of the water column against experiments. They are later than an ideal fluid: the gate takes time, and the
// floor is rough. So the delay is told, and how well the rest agrees.
#include <algorithm>
#include <cmath>

#include "lab/reference_data.hpp"
#include "lab/series.hpp"
#include "lab/verification.hpp"
#include "scenes/build.hpp"

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

/// The front's place over a at these times.
std::vector<double> FrontsOf(ParticleSystemSPH& system) {
  const double width = system.parameters.fluid.region.box.Width();
  std::vector<double> fronts;
  for (const double time : {0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5}) {
    AdvanceTo(system, time * std::sqrt(0.5 * width / -system.parameters.gravity.y));
    const double front = (std::ranges::max(system.State().x) + 0.5 * system.InitialSpacing()) / width;
    fronts.push_back(system.Trouble() ? kBroken : front);
  }
  return fronts;
}

double RmsDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

}  // namespace

/// The front with N/4, N (the system given) and 4 N particles: how the differences fall, whatever it converges to.
std::vector<Verdict> MeasureFrontConvergence(ParticleSystemSPH& system) {
  const auto with = [&](std::size_t particles) {
    SceneRequest request;
    request.scene = "water-column";
    request.particles = particles;
    request.threads = system.parameters.threads;
    return FrontsOf(*MakeSystem(LoadScene(request)));
  };
  const std::size_t n = system.State().Size();
  const std::vector<double> middle = FrontsOf(system);
  const std::vector<double> coarse = with(n / 4), fine = with(4 * n);
  return {{.metric = "front, RMS change from N to 4 N over that from N/4 to N",
           .value = RmsDifference(fine, middle) / RmsDifference(middle, coarse),
           .bar = 0.7072,
           .reference = "first order: 1/2; half of the order: the root",
           .kind = MetricKind::kRatio}};
}

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
    verdicts.push_back(AgainstBand("front, delayed, RMS over a, " + who,
                                   broken ? kBroken : Difference(front, measured, delay), 0.06,
                                   "measured; elsewhere 0.01 to 0.06"));
    verdicts.push_back(AgainstBand("that delay in T, " + who, broken ? kBroken : delay, 0.29,
                                   "the gate's, and friction's; elsewhere 0.22 to 0.29"));
  };
  add("Martin & Moyce", MeasuredFront("martin_moyce1952_a2.25in_n2eq2", 1));
  // In seconds, for a column of one metre.
  add("Koshizuka & Oka", MeasuredFront("koshizuka_oka1996_front_measured", std::sqrt(0.5 / 9.81)));
  return verdicts;
}

}  // namespace sph
