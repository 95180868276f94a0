// How fast the window is: steps, frames and simulated time per second of wall time.
#pragma once

namespace sph {

struct Rates {
  double steps = 0;   ///< [1/s]
  double frames = 0;  ///< [1/s]
  double pace = 0;    ///< simulated seconds per second
};

class RateMeter {
 public:
  void CountSteps(int steps) { steps_ += steps; }
  void CountFrame() { ++frames_; }
  /// Rates over the last half second or so. @param now  wall time [s]; @param simulated  the system's time [s]
  const Rates& Read(double now, double simulated);

 private:
  Rates rates_;
  double since_ = 0;      // wall time at which the counting began [s]
  double simulated_ = 0;  // the system's time then [s]
  long steps_ = 0;
  long frames_ = 0;
};

}  // namespace sph
