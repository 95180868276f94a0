// Seeded random numbers with the same bits on every machine (the standard's distributions do not promise that).
#pragma once

#include <cstdint>
#include <random>

namespace sph {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform on [0, 1), a multiple of 2^-53.
  double Uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  /// Uniform on [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace sph
