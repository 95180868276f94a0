// Flows along walls: water at rest, and flow between plates.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/clock.hpp"
#include "lab/reference_data.hpp"
#include "lab/verification.hpp"
#include "lab/water_at_rest.hpp"

namespace sph {
namespace {

std::vector<double> TimesOfStillWater(const ParticleSystemSPH&) { return {2}; }

std::vector<Verdict> JudgeStillWater(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots) {
  double pressure_error = kBroken, energy = kBroken;
  if (!snapshots.empty()) {
    const Particles& p = snapshots.front().particles;
    const WaterAtRest rest = RestOf(flow, p);
    double squares = 0, kinetic = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double error = snapshots.front().pressure[i] - rest.Pressure(p.Position(i));
      squares += error * error;
      kinetic += 0.5 * p.mass[i] * Dot(p.Velocity(i), p.Velocity(i));
    }
    const double weight = Length(rest.gravity) * rest.Height();
    pressure_error = std::sqrt(squares / static_cast<double>(p.Size())) / (rest.rho0 * weight);
    energy = kinetic / (rest.mass * weight);
  }
  return {{.metric = "L2 of pressure over rho g H at t = 2 s",
           .value = pressure_error,
           .bar = 0.0015,
           .reference = "hydrostatic, exact; best elsewhere 0.0035"},
          {.metric = "kinetic energy over M g H at t = 2 s",
           .value = energy,
           .bar = 1e-9,
           .reference = "0; best elsewhere 1.4e-7"}};
}

/// Flow between plates, started at rest.
struct PlateFlow {
  double width = 0;  ///< between the plates [m]
  double floor = 0;  ///< y of the lower one [m]
  double force = 0;  ///< along them [m/s^2]
  double nu = 0;     ///< [m^2/s]

  double Steady() const { return force * width * width / (8 * nu); }  ///< in the middle [m/s]
  /// u = F/(2 nu) y (L - y) - sum over odd n of 4 F L^2/(nu pi^3 n^3) sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2) [J. P.
  /// Morris, P. J. Fox and Y. Zhu, J. Comput. Phys. 136 (1997) 214, eq. 17].
  double Velocity(double y, double t) const {
    using std::numbers::pi;
    y -= floor;
    double u = force / (2 * nu) * y * (width - y);
    for (int n = 1; n < 40; n += 2) {
      const double wave = n * pi / width;
      u -=
          4 * force * width * width / (nu * std::pow(n * pi, 3)) * std::sin(wave * y) * std::exp(-wave * wave * nu * t);
    }
    return u;
  }
};

PlateFlow PlateFlowOf(const ParticleSystemSPH& flow) {
  const Box box = flow.parameters.fluid.region.box;
  return {box.Height(), box.y0, flow.parameters.gravity.x,
          flow.parameters_sph.viscosity / ReferenceDensity(flow.parameters_sph.equation_of_state)};
}

/// Shares of the time in which the profile approaches the steady one.
std::vector<double> TimesOfPoiseuille(const ParticleSystemSPH& flow) {
  const PlateFlow plates = PlateFlowOf(flow);
  const double slowest = plates.width * plates.width / (std::numbers::pi * std::numbers::pi * plates.nu);
  return {0.1 * slowest, 0.3 * slowest, slowest, 3 * slowest, 6 * slowest};
}

std::vector<Verdict> JudgePoiseuille(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots) {
  const PlateFlow plates = PlateFlowOf(flow);
  double worst = snapshots.empty() ? kBroken : 0;
  for (const FlowSnapshot& snapshot : snapshots) {
    const Particles& p = snapshot.particles;
    double squares = 0;
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double error = p.vx[i] - plates.Velocity(p.y[i], snapshot.time);
      squares += error * error;
    }
    worst = std::max(worst, std::sqrt(squares / static_cast<double>(p.Size())) / plates.Steady());
  }
  return {{.metric = "L2 of velocity over the steady greatest, worst of 5 times",
           .value = worst,
           .bar = 0.001,
           .reference = "exact series; elsewhere 0.0020 to 0.0069",
           .promise = {2, "sums over whole supports of a lattice and its images"}}};
}

/// Places of the front over a against time over sqrt(a/(2g)), until it is near the far wall.
std::vector<Vec2> FrontOfMps() {
  constexpr double kNearTheWall = 3.95;
  std::vector<Vec2> points = ReadReference("koshizuka_oka1996_front_mps");
  std::erase_if(points, [](Vec2 point) { return point.y > kNearTheWall; });
  return points;
}

double WidthOf(const ParticleSystemSPH& flow) { return flow.parameters.fluid.region.box.Width(); }

std::vector<double> TimesOfWaterColumn(const ParticleSystemSPH& flow) {
  const double unit = std::sqrt(0.5 * WidthOf(flow) / -flow.parameters.gravity.y);  // [s]
  std::vector<double> times;
  for (const Vec2 point : FrontOfMps()) times.push_back(unit * point.x);
  return times;
}

std::vector<Verdict> JudgeWaterColumn(const ParticleSystemSPH& flow, std::span<const FlowSnapshot> snapshots) {
  const std::vector<Vec2> points = FrontOfMps();
  double squares = 0;
  for (std::size_t k = 0; k < snapshots.size(); ++k) {
    const Particles& p = snapshots[k].particles;
    const double half_a_particle = 0.5 * std::sqrt(p.mass[0] / ReferenceDensity(flow.parameters_sph.equation_of_state));
    const double front = (*std::ranges::max_element(p.x) + half_a_particle) / WidthOf(flow);
    squares += (front - points[k].y) * (front - points[k].y);
  }
  return {AgainstBand("front, RMS difference over a",
                      snapshots.empty() ? kBroken : std::sqrt(squares / static_cast<double>(snapshots.size())), 0.013,
                      "Koshizuka & Oka 1996, MPS; elsewhere 0.013 to 0.018")};
}

}  // namespace

const Judgement kStillWater{&TimesOfStillWater, &JudgeStillWater};
const Judgement kPoiseuille{&TimesOfPoiseuille, &JudgePoiseuille};
const Judgement kWaterColumn{&TimesOfWaterColumn, &JudgeWaterColumn};

std::vector<Verdict> MeasureStillWater(ParticleSystemSPH& system) { return Judge(kStillWater, system); }

std::vector<Verdict> MeasureTankOfParticles(ParticleSystemSPH& system) {
  std::vector<Verdict> verdicts = MeasureStillWater(system);
  verdicts[1].bar = 1e-8;  // they do not stand as a lattice would go on
  return verdicts;
}

std::vector<Verdict> MeasurePoiseuille(ParticleSystemSPH& system) { return Judge(kPoiseuille, system); }

std::vector<Verdict> MeasureDisorderedPoiseuille(ParticleSystemSPH& system) {
  std::vector<Verdict> verdicts = MeasurePoiseuille(system);
  verdicts[0].bar = 0.003;
  verdicts[0].promise = {1, "sums over particles in disorder"};
  return verdicts;
}

/// Steady from 6 of the slowest times on, 0.6 s: by then the profile is within exp(-6) of the parabola.
std::vector<Verdict> MeasureSteadyPoiseuille(ParticleSystemSPH& system) {
  constexpr double kEnd = 30, kApart = 3;  // [s]
  double worst = 0;
  for (double time = kApart; time < kEnd + 0.5 * kApart && !system.Trouble(); time += kApart) {
    AdvanceTo(system, time);
    const FlowSnapshot now{system.Time(), system.State(), {}};
    worst = std::max(worst, JudgePoiseuille(system, std::span(&now, 1))[0].value);
  }
  return {{.metric = "L2 of velocity over the greatest, worst until t = 30 s",
           .value = system.Trouble() ? kBroken : worst,
           .bar = 0.002,
           .reference = "parabola",
           .kind = MetricKind::kBounded}};
}

std::vector<Verdict> MeasureWaterColumn(ParticleSystemSPH& system) {
  const Stopwatch watch;
  std::vector<Verdict> verdicts = Judge(kWaterColumn, system);
  verdicts.push_back({.metric = "seconds per simulated second",
                      .value = system.Trouble() ? kBroken : watch.Seconds() / system.Time(),
                      .bar = 4,
                      .reference = "elsewhere 15 (DFSPH) to 345, same particles, one core",
                      .kind = MetricKind::kPrice});
  return verdicts;
}

}  // namespace sph
