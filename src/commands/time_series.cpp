#include "commands/time_series.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <span>

#include "base/error.hpp"
#include "io/output_directory.hpp"
#include "io/whole_file.hpp"
#include "particles/diagnostics.hpp"

namespace sph {

TimeSeries::TimeSeries(std::string path, double every) : path_(std::move(path)), every_(every) {
  if (path_.empty()) return;
  const auto folder = std::filesystem::absolute(path_).parent_path();
  PrepareOutputDirectory(folder);
  if (std::filesystem::is_directory(path_)) throw TroubleError("cannot write {}: it is a directory", path_);
  head_ =
      "time [s],step,particles,kinetic_energy [J/m],potential_energy [J/m],internal_energy [J/m],momentum_x [kg/s],"
      "momentum_y [kg/s],angular_momentum [kg m/s],max_speed [m/s],density_min [kg/m^3],density_mean [kg/m^3],"
      "density_max [kg/m^3]\n";
}

void TimeSeries::AddRow(const ParticleSystem& system) {
  if (system.Steps() == last_step_) return;
  last_step_ = system.Steps();
  const Diagnostics d = Diagnose(system);
  // {} prints the shortest text that reads back as the same number, with a point whatever the locale.
  rows_.push_back({system.Time(), next_, text_.size()});
  text_ += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", system.Time(), system.Steps(), system.State().Size(),
                       d.kinetic_energy, d.potential_energy, d.internal_energy, d.momentum.x, d.momentum.y,
                       d.angular_momentum, d.max_speed, d.density.min, d.density.mean, d.density.max);
}

void TimeSeries::Sample(const ParticleSystem& system) {
  constexpr double kRoundOff = 1e-9;
  if (path_.empty() || system.Time() < next_ - kRoundOff) return;
  if (next_ < system.Time() - every_) next_ = system.Time();  // of a run that had no rows until now
  AddRow(system);
  next_ += every_;
}

void TimeSeries::Rewind(const ParticleSystem& system) {
  last_step_ = -1;
  while (!rows_.empty() && rows_.back().time >= system.Time()) {
    next_ = rows_.back().due;
    text_.resize(rows_.back().begin);
    rows_.pop_back();
  }
}

void TimeSeries::Finish(const ParticleSystem& system) {
  if (path_.empty()) return;
  AddRow(system);
  Write();
}

void TimeSeries::Write() const {
  if (!path_.empty()) WriteWholeFile(path_, head_ + text_);
}

void TimeSeries::Transfer(Archive& archive) {
  std::uint64_t rows = rows_.size();
  archive(next_, last_step_, text_, rows);
  Archive::Require(rows <= text_.size());
  rows_.resize(rows);
  for (Row& row : rows_) {
    archive(row.time, row.due, row.begin);
    Archive::Require(row.begin < text_.size());
  }
}

}  // namespace sph
