// The one table of solvers.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "sph/particle_system_sph.hpp"

namespace sph {

struct Solver {
  std::string name;
  std::string what;  ///< one line for people
  std::unique_ptr<ParticleSystemSPH> (*make)(const Parameters&, const ParametersSPH&);
  double usual_h = 0;    ///< smoothing length over spacing, where nothing else is said
  bool viscous = false;  ///< knows forces.viscosity
  bool mirrors = false;  ///< knows walls that are mirrors
};

/// Every solver, in the order in which they are shown.
std::span<const Solver> AllSolvers();

/// The solver of that name, or nullptr.
const Solver* FindSolver(const std::string& name);

}  // namespace sph
