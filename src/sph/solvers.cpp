#include "sph/solvers.hpp"

#include <algorithm>
#include <array>

#include "sph/delta.hpp"
#include "sph/mueller.hpp"

namespace sph {
namespace {

template <typename System>
std::unique_ptr<ParticleSystemSPH> Make(const Parameters& base, const ParametersSPH& sph) {
  return std::make_unique<System>(base, sph);
}

}  // namespace

std::span<const Solver> AllSolvers() {
  static const std::array solvers = {
      Solver{"paper", "cubic spline, summation density, symmetric pressure (Braune & Lewiner)",
             &Make<ParticleSystemSPH>, 1.3, false, false},
      Solver{"mueller", "Poly6, Spiky and Viscosity kernels, ideal gas, viscosity (Mueller; Schuermann's tutorial)",
             &Make<Mueller>, 1.75, true, false},
      Solver{"delta", "Wendland kernels; liquids with density diffusion and particle shifting (Antuono, Marrone, Sun)",
             &Make<Delta>, 2, true, true},
  };
  return solvers;
}

const Solver* FindSolver(const std::string& name) {
  const auto solvers = AllSolvers();
  const auto found = std::find_if(solvers.begin(), solvers.end(), [&](const Solver& s) { return s.name == name; });
  return found == solvers.end() ? nullptr : &*found;
}

}  // namespace sph
