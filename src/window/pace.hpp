// How many steps a frame makes: simulated time keeps pace with the clock where the machine can, and a frame's work is
// bounded.
#pragma once

#include "base/clock.hpp"
#include "window/session.hpp"

namespace sph {

class Pace {
 public:
  /// @param budget  wall time that the steps of one frame may take [s]; at least one step is made when one is due.
  explicit Pace(double budget) : budget_(budget) {}

  /// Makes the steps that are due after `elapsed` seconds of wall time since the last frame. Time that the machine
  /// cannot make up for within the budget is given up: the simulation is then slower than the clock, and the window
  /// stays alive.
  /// @return the number of steps made.
  int Advance(Session& session, double elapsed);

 private:
  double budget_;
  double due_ = 0;  // simulated time that the clock is ahead [s]
};

}  // namespace sph
