// How many steps are due: simulated time keeps pace with the clock where the machine can, and the work done in a row is
// bounded.
#pragma once

#include <chrono>

#include "base/clock.hpp"
#include "window/session.hpp"

namespace sph {

class Pace {
 public:
  /// @param budget  wall time that the steps of one call may take [s]; at least one step is made when one is due.
  /// @param debt    wall time that later calls make up for if the budget was not enough [s].
  explicit Pace(double budget, double debt = 0) : budget_(budget), debt_(debt) {}

  /// Makes the steps that are due after `elapsed` seconds of wall time since the last call. Time that the machine
  /// cannot make up for is given up: the simulation is then slower than the clock, and whoever calls stays responsive.
  /// @return the number of steps made.
  int Advance(Session& session, double elapsed);

  /// From the last call until the next step is due, and no less than is worth a call; an hour while nothing will be.
  std::chrono::duration<double> Wait(const Session& session) const;

 private:
  double budget_;
  double debt_;
  double due_ = 0;  // simulated time that the clock is ahead [s]
};

}  // namespace sph
