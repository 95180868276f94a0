// Seeded choices of those who make scenes up.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.hpp"

namespace sph {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  bool Chance(double probability) { return random_.Uniform() < probability; }
  std::size_t Below(std::size_t n) { return static_cast<std::size_t>(random_.Uniform() * static_cast<double>(n)); }
  template <typename T>
  const T& OneOf(const std::vector<T>& all) {
    return all[Below(all.size())];
  }
  double Uniform(double low, double high) { return random_.Uniform(low, high); }
  /// Between two positive numbers, every power of ten as likely as the others.
  double Scale(double low, double high) { return low * std::pow(high / low, random_.Uniform()); }
  /// Mostly of the size of what scenes have, now and then of any size or sign.
  double Number() {
    if (Chance(0.05)) return 0;
    const double reach = Chance(0.1) ? 300 : Chance(0.3) ? 6 : 2;
    const double size = std::pow(10, random_.Uniform(-reach, reach));
    return Chance(0.15) ? -size : size;
  }

 private:
  Random random_;
};

}  // namespace sph
