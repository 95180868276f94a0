// The paper's SPH subclass (V): a particle system whose accelerations include the pressure of a fluid.
#pragma once

#include <string>

#include "neighbours/cell_grid.hpp"
#include "particles/particle_system.hpp"
#include "sph/equations_of_state.hpp"
#include "sph/kernels.hpp"
#include "sph/neighbour_store.hpp"

namespace sph {

/// The paper's ParametersSPH[N_SPH_PARAMS], by name.
struct ParametersSPH {
  double smoothing_length = 0;  ///< h [m]; for the tutorial's kernels h is the support radius
  EquationOfState equation_of_state;
  double viscosity = 0;            ///< mu [Pa s]; solver mueller only
  bool mueller_published = false;  ///< solver mueller: with the mistakes of its published program
};

class ParticleSystemSPH : public ParticleSystem {
 public:
  ParticleSystemSPH(const Parameters& base, const ParametersSPH& sph);

  std::span<const double> Density() const override { return density_; }
  std::span<const double> Pressure() const override { return pressure_; }
  double InternalEnergy() const override;
  std::vector<PassPlan> Plan() const override;

  /// The kernel's name, for reports.
  virtual std::string KernelName() const { return "cubic spline"; }
  /// Support radius of the kernel [m].
  virtual double Support() const { return CubicSpline<2>::kSupport * parameters_sph.smoothing_length; }
  /// Mean number of neighbours within the support in the last step, the particle itself not counted.
  double MeanNeighbours() const;

  /// May be changed between steps.
  ParametersSPH parameters_sph;

 protected:
  /// PrepareGrid, neighbours, density (eq. 8) and pressure of every particle.
  void ComputePressures();
  /// The pressure terms of the accelerations (eq. 10), and whatever else acts between neighbours.
  virtual void AddSpatialInteraction();
  void ComputeAccelerations() override;
  void RestoreParameters() override;
  double LongestMove() const override { return Support(); }

  /// Sorts the particles by cell.
  void PrepareGrid();
  /// The runs of particles in the nine cells around a position.
  std::array<Run, 3> FindCells(Vec2 position) const { return grid_.FindCells(position); }
  /// Density of the block's particles.
  virtual void ComputeDensities(const NeighbourBlock& block);
  /// Calls work(block) for every block of the neighbour store, on all threads.
  template <typename Work>
  void ForEachBlock(Work work);

  CellGrid grid_;
  NeighbourStore neighbours_;
  std::vector<double> density_;        // [kg/m^3]
  std::vector<double> pressure_;       // [Pa]
  std::vector<double> pressure_term_;  // P/rho^2 [m^5/(kg s^2)]

 private:
  ParametersSPH initial_parameters_sph_;
};

template <typename Work>
void ParticleSystemSPH::ForEachBlock(Work work) {
  const std::size_t blocks = neighbours_.size();
#pragma omp parallel for schedule(dynamic, 4) num_threads(ThreadCount()) if (blocks > 4)
  for (std::size_t b = 0; b < blocks; ++b) work(neighbours_[b]);
}

}  // namespace sph
