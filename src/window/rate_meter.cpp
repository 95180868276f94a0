#include "window/rate_meter.hpp"

#include <algorithm>

namespace sph {

const Rates& RateMeter::Read(double now, double simulated) {
  constexpr double kPeriod = 0.5;  // [s]: numbers that change faster cannot be read
  const double elapsed = now - since_;
  if (elapsed < kPeriod) return rates_;
  // After a reset the simulated time starts again from 0.
  rates_ = {static_cast<double>(steps_) / elapsed, static_cast<double>(frames_) / elapsed,
            std::max(0.0, simulated - simulated_) / elapsed};
  since_ = now;
  simulated_ = simulated;
  steps_ = frames_ = 0;
  return rates_;
}

}  // namespace sph
