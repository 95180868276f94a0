#include "lab/run_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace sph {
namespace {

double Mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

void EnergyBudget::Add(double kinetic, double stored, double put_in) {
  const double energy = kinetic + stored - put_in;
  highest_ = std::max(highest_, energy);
  lowest_stored_ = std::min(lowest_stored_, stored - put_in);
  sum_ += energy;
  if (++looks_ < kWindow) return;
  const double mean = sum_ / kWindow;
  looks_ = 0;
  sum_ = 0;
  const double growth = mean - least_.value_or(mean);
  least_ = std::min(mean, least_.value_or(mean));
  if (growth > Allowance() && flaw_.empty()) {
    flaw_ = fmt::format("energy grew by {:.3g} J/m, of {:.3g} J/m that could become motion", growth,
                        highest_ - lowest_stored_);
  }
}

/// Walls that slide in opposite directions put in what they must until the fluid moves with them: its speed then is at
/// most theirs and its own together, so that with its own energy A the kinetic one is M/2 (U + sqrt(2A/M))^2 at most.
double EnergyBudget::Allowance() const {
  const double available = std::max(0.0, highest_ - lowest_stored_);
  const double dragged = 0.5 * mass_ * slide_ * slide_ + slide_ * std::sqrt(2 * mass_ * available);
  return kMostGrowth * available + dragged + still_;
}

void VolumeCheck::Add(double by_density, std::optional<double> by_place, double unsure) {
  if (!flaw_.empty()) return;
  const double drift = by_density / nominal_ - 1;
  if (!(std::abs(drift) <= kMostDrift)) {
    flaw_ = fmt::format("volume by densities is off by {:.1f} %", 100 * drift);
  }
  if (!by_place) return;
  if (!first_) first_ = by_place;
  const double least = (1 - kMostDrift) * std::min(*first_, nominal_) - unsure;
  const double most = (1 + kMostDrift) * std::max(*first_, nominal_) + unsure;
  const bool kept = *by_place >= least && *by_place <= most;
  out_of_range_ = kept ? 0 : out_of_range_ + 1;
  if (out_of_range_ < kLooksInARow || !flaw_.empty()) return;
  flaw_ = fmt::format("the area that particles fill went from {:.4g} to {:.4g} times the volume", *first_ / nominal_,
                      *by_place / nominal_);
}

std::string RestCheck::Flaw() const {
  const std::size_t quarter = kinetic_.size() / 4;
  if (quarter == 0) return {};
  const std::span all(kinetic_);
  const double before = Mean(all.subspan(all.size() - 2 * quarter, quarter));
  const double now = Mean(all.last(quarter));
  if (now <= still_ || now <= kMostGrowth * before) return {};
  return fmt::format("no rest: in the last quarter of the run the kinetic energy is {:.3g} J/m, {:.3g} before", now,
                     before);
}

}  // namespace sph
