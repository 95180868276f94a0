// Run time against error as CSV, as a plot, and as a table: what 1 % and 0.1 % cost, orders of convergence, where float
// ends.
#pragma once

#include <span>
#include <string>

#include "lab/plot.hpp"
#include "lab/price_runs.hpp"

namespace sph {

/// What to reach: 1 % and 0.1 %.
inline constexpr double kWantedErrors[] = {0.01, 0.001};

/// Every run of the case, also those left out; the first line has the column names with units. Values in full
/// precision; fields with a comma are quoted.
std::string PricesAsCsv(const PricedCase& of);

/// Greatest error against seconds, a series a method that held anywhere, and the frontier of all.
/// `others` are drawn as points of other programs.
Plot PricePlot(const PricedCase& of, std::span<const Series> others = {});

/// What a solver reaches in one metric of a case, with its best step and precision.
struct PriceSummary {
  std::string case_name;
  std::string metric;
  std::string solver;
  std::vector<Reach> reached = {};  ///< as kWantedErrors
  double least_error = kBroken;     ///< of all runs; with:
  std::string method = {};          ///< "float adaptive"
  std::size_t particles = 0;
  double seconds = 0;
  std::optional<double> order = {};  ///< of convergence: fixed step, double, the three finest numbers of particles
  std::string note = {};             ///< why there is nothing
};

/// A row a metric and solver; of a solver without a run that held, one row.
std::vector<PriceSummary> Summarise(const PricedCase& of);

std::string SummaryTableHead();
std::string SummaryTableRow(const PriceSummary& row);
std::string SummariesAsCsv(std::span<const PriceSummary> rows);

/// Down to which error the passes in float do as well as those in double, to a tenth: of pairs of runs that are alike
/// otherwise, where double is not wrong by more than 10 % itself.
struct FloatEnd {
  std::string case_name;
  std::string metric;
  std::string solver;
  double good_error = kBroken;  ///< least error in double that float reaches, too
  std::size_t good_particles = 0;
  double worst_ratio = 0;  ///< greatest error in float over that in double
  std::size_t worst_particles = 0;
  double worst_float = 0;  ///< the two errors
  double worst_double = 0;
};

/// A row a metric and solver that has pairs.
std::vector<FloatEnd> FloatEnds(const PricedCase& of);
std::string FloatTableHead();
std::string FloatTableRow(const FloatEnd& row);
std::string FloatEndsAsCsv(std::span<const FloatEnd> rows);

/// `text` as a field of a CSV file.
std::string CsvField(const std::string& text);

}  // namespace sph
