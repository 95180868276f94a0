// The CSV file of `run --csv`: sums over the particles against time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "particles/particle_system.hpp"

namespace sph {

class TimeSeries {
 public:
  /// @param path   the file; nothing is sampled or written if it is empty. TroubleError at once if it is a folder, or
  /// its own folder cannot be written.
  /// @param every  simulated time between rows [s]; 0: a row at every call
  TimeSeries(std::string path, double every);

  /// Adds a row if one is due.
  void Sample(const ParticleSystem& system);
  /// Takes back the rows of later times than the system's, which has gone back.
  void Rewind(const ParticleSystem& system);
  /// Adds the last row and writes the file, whole or not at all.
  void Finish(const ParticleSystem& system);
  /// Writes the file as it is now.
  void Write() const;

  /// The rows so far, and when the next is due.
  void Transfer(Archive& archive);

 private:
  void AddRow(const ParticleSystem& system);

  std::string path_;
  double every_;
  double next_ = 0;      // [s]
  long last_step_ = -1;  // of the last row
  /// Begins in text_ at `begin`.
  struct Row {
    double time = 0;  ///< [s]
    double due = 0;   ///< next_ before it [s]
    std::uint64_t begin = 0;
  };
  std::string head_, text_;
  std::vector<Row> rows_;
};

}  // namespace sph
