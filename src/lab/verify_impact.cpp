// The dam break that hits a wall: when a computation without friction says, and with the pressure of Lobovsky's hundred
// repetitions.
#include <algorithm>
#include <cmath>

#include "lab/reference_data.hpp"
#include "lab/series.hpp"
#include "lab/verification.hpp"
#include "lab/wall_probe.hpp"

namespace sph {
namespace {

/// sqrt(H/g) [s], the unit of T.
double UnitOfTime(const ParticleSystemSPH& system) {
  return std::sqrt(system.parameters.fluid.region.box.Height() / -system.parameters.gravity.y);
}

/// rho g H [Pa], the unit of P.
double UnitOfPressure(const ParticleSystemSPH& system) {
  return -ReferenceDensity(system.parameters_sph.equation_of_state) * system.parameters.gravity.y *
         system.parameters.fluid.region.box.Height();
}

double FarWall(ParticleSystemSPH& system) { return FindWall(system.parameters.walls, "right")->at; }

/// What a gauge `height` [m] above the floor in the far wall feels: (T, P), P being the mean over the time since the
/// point before it, as of a gauge that misses nothing. Until it breaks down.
PointSeries SignalOf(ParticleSystemSPH& system, const std::vector<double>& times, double height) {
  const Vec2 gauge{FarWall(system), height};
  PointSeries signal;
  for (const double time : times) {
    double sum = 0, since = 0;
    while (system.Time() < UnitOfTime(system) * time && !system.Trouble()) {
      system.Step();
      sum += system.parameters.time_step * PressureAtWall(system, gauge);
      since += system.parameters.time_step;
    }
    if (since > 0) {
      signal.push_back({(system.Time() - 0.5 * since) / UnitOfTime(system), sum / since / UnitOfPressure(system)});
    }
  }
  return signal;
}

}  // namespace

std::vector<Verdict> MeasureWallArrival(ParticleSystemSPH& system) {
  constexpr double kConverged = 2.34;
  constexpr double kLongEnough = 3;
  const double at_the_wall = FarWall(system) - 0.5 * system.InitialSpacing();
  const double unit = UnitOfTime(system);
  PointSeries front;
  const auto note = [&] { front.push_back({system.Time() / unit, std::ranges::max(system.State().x)}); };
  note();
  while (front.back().y < at_the_wall && system.Time() < kLongEnough * unit && !system.Trouble()) {
    system.Step();
    note();
  }
  return {{.metric = "T of the first particle's edge there, difference",
           .value = FirstAbove(front, at_the_wall) - kConverged,
           .bar = 0.03,
           .reference = "t sqrt(g/H) = 2.34, computed without friction, H/dx = 400",
           .promise = {1, "the tongue of the front is a few spacings thin"}}};
}

std::vector<Verdict> MeasureWallImpact(ParticleSystemSPH& system) {
  constexpr double kGauge = 0.015;  // [m] above the floor, the second gauge
  constexpr double kWet = 0.1;      // of rho g H: the gauge has felt the water
  const auto band = ReadReferenceRows("lobovsky2014_H300_s2_percentiles", 4);
  std::vector<double> times;
  PointSeries median;
  for (const auto& row : band) {
    times.push_back(row[0]);
    median.push_back({row[0], row[2]});
  }
  const PointSeries signal = SignalOf(system, times, kGauge);
  const double measured = FirstAbove(median, kWet);
  const double delay = measured - FirstAbove(signal, kWet);
  double outside = 0, whole = 0, impulse = 0, measured_impulse = 0;
  for (std::size_t k = 1; k < band.size(); ++k) {
    const auto& row = band[k];
    if (row[0] < measured) continue;
    const double lasts = row[0] - band[k - 1][0];  // rows are denser where the pressure is high
    const double now = ValueAt(signal, row[0] - delay);
    whole += lasts;
    if (!(row[1] <= now && now <= row[3])) outside += lasts;
    impulse += lasts * now;
    measured_impulse += lasts * row[2];
  }
  const bool broken = system.Trouble().has_value();
  const auto band_of = [&](const char* metric, double value, double bar, const char* reference) {
    return AgainstBand(metric, broken ? kBroken : value, bar, reference);
  };
  return {
      band_of("T of 0.1 rho g H at z = 15 mm, difference", -delay, 0.03, "Lobovsky 2014, median of 100 runs: 2.461"),
      band_of("pressure there, share of time outside the 95 % band", outside / whole, 0.3,
              "of these runs, aligned at that T; delta-SPH with H/dx = 400: 0.82"),
      band_of("impulse there from then to T = 7.1, relative error", impulse / measured_impulse - 1, 0.1,
              "of the median; delta-SPH with H/dx = 400: 0.34")};
}

std::vector<Verdict> MeasureWallPressure(ParticleSystemSPH& system) {
  // Before T = 2.5 the gauge was dry, and what was digitised there is noise.
  constexpr double kFrom = 2.5, kTo = 7.2, kApart = 0.05;
  PointSeries measured = ReadReference("buchner2002_pressure");
  std::ranges::sort(measured, {}, &Vec2::x);
  std::vector<double> times;
  for (double time = kFrom - 1; time < kTo; time += kApart) times.push_back(time);
  const double height = system.parameters.fluid.region.box.Height();
  const PointSeries signal = SignalOf(system, times, 0.2 * height);
  double difference = 0, impulse = 0, measured_impulse = 0;
  int points = 0;
  for (double time = kFrom; time < kTo; time += kApart) {
    const double now = ValueAt(signal, time), then = ValueAt(measured, time);
    difference += std::abs(now - then);
    impulse += now;
    measured_impulse += then;
    ++points;
  }
  const bool broken = system.Trouble().has_value();
  return {AgainstBand("pressure at z = 0.2 H, mean difference over rho g H", broken ? kBroken : difference / points,
                      0.1, "Buchner 2002, one run"),
          AgainstBand("impulse there from T = 2.5 to 7.2, relative error",
                      broken ? kBroken : impulse / measured_impulse - 1, 0.1, "the same")};
}

}  // namespace sph
