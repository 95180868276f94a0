// How a case is run by a solver, with a step, in a precision and with a number of particles; or why it cannot be.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lab/verification.hpp"

namespace sph {

enum class StepChoice { kScene, kHalf, kAdaptive };

/// What a case is run with, its resolution excepted.
struct Method {
  std::string solver;
  StepChoice step = StepChoice::kScene;
  Precision precision = Precision::kDouble;

  friend bool operator==(const Method&, const Method&) = default;
};

/// "fixed", "half", "adaptive"
std::string_view NameOf(StepChoice step);

/// A system at its start, or why there is none.
struct Prepared {
  std::unique_ptr<ParticleSystemSPH> system;
  std::string why_not;
};

/// The case's scene for that method. To its own solver it goes as it is. Another solver gets all of it but what the
/// case says of the method (the keys method.*): a smoothing length that is usual for it where the scene's file is not
/// made for it, walls that push where the case's are mirrors, and the case's step, or the longest that it bears at the
/// start if that is shorter. It has none of a scene with viscosity or walls to which the fluid sticks that the solver
/// does not know.
Prepared Prepare(const VerificationCase& of, const Method& method, std::size_t particles, int threads);

/// Numbers of particles from coarse to fine, about factors of two apart, from 1/64 to 4 times the case's own, that one
/// included: those with which the rows and columns of a lattice fill a box, where there are such.
std::vector<std::size_t> Resolutions(const VerificationCase& of);

}  // namespace sph
