#include "lab/speed_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/plot_style.hpp"

namespace sph {
namespace {

/// Million particle-steps per second of `ns` for one.
double MillionPerSecond(double ns) { return 1e3 / ns; }

template <typename Wanted>
Series CurveOf(std::span<const SpeedResult> results, const std::string& name, Wanted wanted) {
  Series series = Curve(name, {}, {});
  for (const SpeedResult& r : results) {
    if (r.flow != Flow::kTank || !wanted(r)) continue;
    series.x.push_back(static_cast<double>(r.particles));
    series.y.push_back(MillionPerSecond(r.ns.least));
  }
  return series;
}

/// The limit of one thread, as dashed as all theory, in the colour of what it limits.
Series LimitOf(std::span<const SpeedResult> results, Precision precision, Colour colour) {
  Series series = Theory(fmt::format("limit of 1 thread, {}", NameOf(precision)), {}, {});
  series.colour = colour;
  for (const SpeedResult& r : results) {
    const double n = static_cast<double>(r.particles);
    if (r.flow != Flow::kTank || r.precision != precision || r.threads != 1) continue;
    if (std::find(series.x.begin(), series.x.end(), n) != series.x.end()) continue;
    series.x.push_back(n);
    series.y.push_back(MillionPerSecond(r.limit_ns));
  }
  return series;
}

}  // namespace

std::string_view NameOf(Precision precision) { return precision == Precision::kFloat ? "float" : "double"; }

std::string SpeedAsCsv(std::span<const SpeedResult> results) {
  std::string text =
      "flow,particles,threads,precision,instruction_set,repetitions,steps,least [ns],median [ns],greatest [ns],"
      "particle_steps_per_second [1/s],grid [ns],density [ns],pressure [ns],walls [ns],integrate [ns],limit [ns],"
      "neighbours,steps_per_list,memory [bytes],density_error,acceleration_error\n";
  for (const SpeedResult& r : results) {
    text += fmt::format("{},{},{},{},{},{},{}", NameOf(r.flow), r.particles, r.threads, NameOf(r.precision),
                        r.instruction_set, r.repetitions, r.steps);
    for (const double value : {r.ns.least, r.ns.median, r.ns.greatest, 1e9 / r.ns.least, r.grid_ns, r.density_ns,
                               r.pressure_ns, r.walls_ns, r.integrate_ns, r.limit_ns, r.neighbours, r.steps_per_list,
                               r.bytes, r.errors.density, r.errors.acceleration}) {
      text += fmt::format(",{:.6g}", value);
    }
    text += '\n';
  }
  return text;
}

std::string SpeedTableHead() {
  return fmt::format(
      "{:>57} {:>52}\n{:<8} {:>8} {:>7} {:>6} {:>8} {:>7} {:>7} {:>7} {:>6} {:>7} {:>8} {:>5} {:>9} {:>6} {:>6} {:>5} "
      "{:>6} {:>5} {:>8} {:>8}\n",
      "time of a particle and step [ns]", "of the least, in the passes [ns]", "flow", "N", "threads", "", "set",
      "least", "median", "most", "grid", "density", "pressure", "walls", "integrate", "limit", "M/s", "near", "s/list",
      "bytes", "rho err", "acc err");
}

std::string SpeedTableRow(const SpeedResult& r) {
  return fmt::format(
      "{:<8} {:>8} {:>7} {:>6} {:>8} {:>7.2f} {:>7.2f} {:>7.2f} {:>6.2f} {:>7.2f} {:>8.2f} {:>5.2f} {:>9.2f} {:>6.2f} "
      "{:>6.2f} {:>5.1f} {:>6.1f} {:>5.0f} {:>8.1e} {:>8.1e}\n",
      NameOf(r.flow), r.particles, r.threads, NameOf(r.precision), r.instruction_set, r.ns.least, r.ns.median,
      r.ns.greatest, r.grid_ns, r.density_ns, r.pressure_ns, r.walls_ns, r.integrate_ns, r.limit_ns,
      MillionPerSecond(r.ns.least), r.neighbours, r.steps_per_list, r.bytes, r.errors.density, r.errors.acceleration);
}

std::string DescribeLimit(const RatesOfThreads& rates) {
  const auto line = [&](Precision precision) {
    const PassOperations operations = OperationsPerVector(precision);
    const double one = rates.at(1).Of(precision), two = rates.at(2).Of(precision);
    return fmt::format(
        "  {:<6} {:6.1f} thousand million a second, two threads {:.2f} times as many; {} + {} operations for each "
        "neighbour\n",
        NameOf(precision), 1e-9 * one, two / one, operations.density, operations.pressure);
  };
  return "limit: the multiply-adds that threads were measured to make on vectors in registers, over the operations of\n"
         "density and pressure for the neighbours alone, as if no lane were wasted and all else were free\n" +
         line(Precision::kFloat) + line(Precision::kDouble);
}

Plot SpeedPlot(std::span<const SpeedResult> results) {
  Plot plot;
  plot.title = "Water nearly at rest, 20 neighbours: speed of the whole step";
  plot.x = {"particles", Scale::kLog};
  plot.y = {"million particle-steps per second", Scale::kLog};
  if (results.empty()) return plot;
  std::vector<std::string> sets;  // as measured, the best one last
  for (const SpeedResult& r : results) {
    if (std::find(sets.begin(), sets.end(), r.instruction_set) == sets.end()) sets.push_back(r.instruction_set);
  }
  const auto curve = [&](Precision precision, const std::string& set, int threads, std::size_t colour) {
    const auto name = fmt::format("{}, {}, {} thread{}", NameOf(precision), set, threads, threads == 1 ? "" : "s");
    Series series = CurveOf(results, name, [&](const SpeedResult& r) {
      return r.precision == precision && r.instruction_set == set && r.threads == threads;
    });
    series.colour = kPalette[colour];
    return series;
  };
  const std::string& best = sets.back();
  plot.series = {LimitOf(results, Precision::kFloat, kPalette[1]), LimitOf(results, Precision::kDouble, kPalette[4]),
                 curve(Precision::kFloat, best, 2, 0), curve(Precision::kFloat, best, 1, 1)};
  for (std::size_t k = 2; k <= sets.size(); ++k) {
    plot.series.push_back(curve(Precision::kFloat, sets[sets.size() - k], 1, k));
  }
  plot.series.push_back(curve(Precision::kDouble, best, 1, 4));
  return plot;
}

}  // namespace sph
