#include "lab/skips_report.hpp"

#include <fmt/format.h>

namespace sph {

std::string SkipsAsCsv(std::span<const SkipResult> results) {
  std::string text =
      "mechanism,with,without,unit,repetitions,with_least,with_median,with_greatest,without_least,without_median,"
      "without_greatest,ratio,error,error_with,error_without\n";
  for (const SkipResult& r : results) {
    text += fmt::format("{},{},{},{},{}", r.mechanism, r.what_with, r.what_without, r.unit, r.repetitions);
    for (const double value : {r.with.least, r.with.median, r.with.greatest, r.without.least, r.without.median,
                               r.without.greatest, r.Ratio()}) {
      text += fmt::format(",{:.6g}", value);
    }
    text += fmt::format(",{},{:.3g},{:.3g}\n", r.error, r.error_with, r.error_without);
  }
  return text;
}

std::string SkipsTableHead() {
  return "least of the repetitions, which took turns, and the median in brackets; ns of a particle and step where no\n"
         "unit is named\n\n";
}

std::string SkipsTableRow(const SkipResult& r) {
  const bool ns = r.unit == kNsOfAStep;
  const auto line = [&](const std::string& what, const Spread& time, double error) {
    return fmt::format("  {:<28} {:>9.4g} ({:.4g}){} {}: {:.2g}\n", what, time.least, time.median,
                       ns ? "" : " " + r.unit, r.error, error);
  };
  return fmt::format("{}: {:.2f} times as fast without\n", r.mechanism, r.Ratio()) +
         line(r.what_with, r.with, r.error_with) + line(r.what_without, r.without, r.error_without);
}

}  // namespace sph
