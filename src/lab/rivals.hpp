// What others reach in a case, and how long the solver `delta` takes to be as good.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/price_runs.hpp"
#include "lab/pysph.hpp"

namespace sph {

/// A rival's error in one metric, its time, and ours to the same error.
struct Rivalry {
  std::string case_name;
  std::string who;
  std::size_t particles = 0;
  std::string metric;
  double error = 0;
  double seconds = 0;
  Reach ours;  ///< along the frontier of solver delta

  /// Our time over the rival's; of an upper bound, that.
  double Ratio() const { return ours.seconds / seconds; }
};

/// A row a metric of the case.
std::vector<Rivalry> Compare(const PricedCase& of, const RivalRun& rival);

/// The paper's solver in the paper's own set-up, where the case has one: what it reaches, and what the paper reports,
/// in the same time. Its run is that of `priced`, or made here if it was left out there; none if only small systems are
/// wanted.
std::vector<RivalRun> PaperRivals(const VerificationCase& of, const PricedCase& priced, const PriceOptions& options);

std::string RivalTableHead();
std::string RivalTableRow(const Rivalry& row);
std::string RivalriesAsCsv(std::span<const Rivalry> rows);

}  // namespace sph
