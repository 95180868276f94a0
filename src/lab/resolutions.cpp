#include "lab/resolutions.hpp"

#include <cmath>

namespace sph {

std::size_t NearestFilling(const Box& box, double wanted, double factor) {
  constexpr double kRoundOff = 1e-6;
  std::size_t nearest = 0;
  double distance = std::log(factor);
  for (double columns = 1; columns * columns * box.Height() / box.Width() < factor * wanted; ++columns) {
    const double rows = columns * box.Height() / box.Width();
    if (std::abs(rows - std::round(rows)) > kRoundOff * rows || rows < 0.5) continue;
    const double number = columns * std::round(rows);
    if (std::abs(std::log(number / wanted)) > distance) continue;
    distance = std::abs(std::log(number / wanted));
    nearest = static_cast<std::size_t>(number);
  }
  return nearest;
}

bool IsLatticeInBox(const Block& block) {
  return block.region.radius <= 0 && block.arrange != Arrangement::kRandom && block.arrange != Arrangement::kHexagonal;
}

}  // namespace sph
