// The two flows whose run time is measured: water nearly at rest in a tank, and a column of it that breaks.
#pragma once

#include <string_view>

#include "scenes/scene.hpp"

namespace sph {

enum class Flow {
  kTank,      ///< fills a tank of 2 m x 1 m; motion damping of 8 sqrt(g/H), as the paper's dam has while it settles
  kCollapse,  ///< a column of 1 m x 1 m breaks in a box that is 4 m wide, undamped
};

/// "tank", "collapse"
std::string_view NameOf(Flow flow);

/// sqrt(H/g) [s], H = 1 m being the depth of both at the start.
double TimeScale();

/// N particles of water on a lattice, shaken by up to a tenth of the spacing dx, with the usual numbers of weakly
/// compressible SPH: speed of sound 10 sqrt(g H), Tait's exponent 7, h = 1.3 dx (20 neighbours), dt = 0.4 h/c [J. J.
/// Monaghan, "Simulating free surface flows with SPH", J. Comput. Phys. 110 (1994) 399]. On all threads.
Scene SpeedScene(Flow flow, std::size_t particles, Precision precision);

}  // namespace sph
