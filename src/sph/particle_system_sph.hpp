// The paper's SPH subclass (V): a particle system whose accelerations include the pressure of a fluid.
#pragma once

#include <string>

#include "neighbours/neighbour_search.hpp"
#include "particles/particle_system.hpp"
#include "sph/cluster_passes.hpp"
#include "sph/delta_passes.hpp"
#include "sph/equations_of_state.hpp"
#include "sph/fluid_arrays.hpp"
#include "sph/initial_flow.hpp"
#include "sph/kernels.hpp"

namespace sph {

/// Of the passes over neighbours; positions and velocities are always kept in double.
enum class Precision { kFloat, kDouble };

/// How solver delta computes the physical viscosity of a liquid.
enum class ViscousForm {
  kLaplacian,  ///< mu lap u, to fourth order inside: for walls and periods [Morris, Fox & Zhu 1997, eq. 22]
  /// div(2 mu D), along the lines between particles: it leaves a free surface free of stress, and keeps angular
  /// momentum [J. J. Monaghan & R. A. Gingold 1983; A. Colagrossi et al., Phys. Rev. E 84 (2011) 026705]
  kStress,
};

/// Of solver delta.
struct DeltaParameters {
  SmoothingKernel kernel = SmoothingKernel::kWendlandC2;
  double diffusion = 0.2;           ///< delta, of density in a liquid
  double artificial_viscosity = 0;  ///< alpha, in a liquid
  ViscousForm viscous_form = ViscousForm::kLaplacian;
  double sound_damping = 0.3;    ///< alpha of a bulk viscosity alpha h c rho0, in a liquid
  double surface_tension = 0;    ///< sigma [N], of a liquid
  bool shifting = true;          ///< of the particles of a liquid
  bool tensile_control = false;  ///< particles of a liquid do not pull at each other; this costs conservation
  /// Of pressure in a liquid, to fourth order where particles fill the support. It is not the divergence's adjoint, so
  /// that at a free surface energy is not kept.
  bool sharp_gradient = false;
};

/// The paper's ParametersSPH[N_SPH_PARAMS], by name.
struct ParametersSPH {
  double smoothing_length = 0;  ///< h [m]; for the tutorial's kernels h is the support radius
  EquationOfState equation_of_state;
  double viscosity = 0;            ///< mu [Pa s]; solver mueller, and delta for liquids
  bool mueller_published = false;  ///< solver mueller: with the mistakes of its published program
  Precision precision = Precision::kDouble;
  DeltaParameters delta = {};
  const InitialFlow* flow = nullptr;  ///< null: at rest
  double flow_speed = 1;              ///< U of that flow [m/s]
  bool graded_masses = false;         ///< in proportion to the flow's density, not equal
  Periods periods = {};               ///< periodic boundaries
};

class ParticleSystemSPH : public ParticleSystem {
 public:
  ParticleSystemSPH(const Parameters& base, const ParametersSPH& sph);

  std::vector<double> Density() const override;
  std::vector<double> Pressure() const override;
  double InternalEnergy() const override;
  std::vector<PassPlan> Plan() const override;
  std::vector<StepLimit> StepLimits() const override;

  /// The kernel's name, for reports.
  virtual std::string KernelName() const { return "cubic spline"; }
  /// Support radius of the kernel [m].
  virtual double Support() const { return CubicSpline<2>::kSupport * parameters_sph.smoothing_length; }
  /// Mean number of neighbours within the support at the last step's positions, the particle itself not counted.
  /// Counted when asked for.
  double MeanNeighbours() const;
  /// The initial flow at a point; the density that its scale takes is that of a liquid's reference.
  FlowAtPoint FlowAt(Vec2 point) const;
  const NeighbourSearch& Neighbours() const { return neighbours_; }
  /// See NeighbourSearch::KeepLists.
  void KeepLists(bool keep) { neighbours_.KeepLists(keep); }
  /// Of all arrays that grow with the particles.
  virtual std::size_t Bytes() const;

  void Transfer(Archive& archive) override;

  /// May be changed between steps, the precision excepted.
  ParametersSPH parameters_sph;

 protected:
  /// PrepareGrid, then density (eq. 8) and pressure of every particle.
  void ComputePressures();
  /// The pressure terms of the accelerations (eq. 10), and whatever else acts between neighbours, of a block's
  /// particles.
  virtual void AddSpatialInteraction(const ListBlock& block);
  void ComputeAccelerations() override;
  void InitialPositions() override;
  void RestoreParameters() override;
  double LongestMove() const override;
  /// All in the periodic box; between two sorts some are a little beyond it.
  std::optional<std::pair<std::vector<double>, std::vector<double>>> ShownPositions() const override;
  void ForgetNeighbours() override;

  /// Brings the neighbour lists up to date: sorts the particles into clusters and finds what is near each, where they
  /// have not moved as the lists that there are foresaw.
  void PrepareGrid();
  /// Finds the clusters around each of the block's, and of their particles those within reach: the neighbour store's
  /// lists.
  void FindCells(ListBlock& block);
  void FindCellsOfWalls();
  /// The greatest stable c dt/h of leapfrog on lattices of this solver's fluid.
  virtual double StableSoundStep() const;
  /// How long before they are made the lists shall hold, too [s].
  virtual double ListsHoldBefore() const { return 0; }
  /// Makes room in the arrays of the passes for n particles, images and wall particles included, and the padding.
  virtual void ResizeArrays(std::size_t n);
  /// Periodic ends, and walls that the fluid sees, where they were so long ago [s].
  Ends EndsBefore(double seconds) const;
  /// Positions [m] that the passes shall see; those of images and wall particles follow from them and the ends of that
  /// time.
  void SetPositions(std::span<const double> x, std::span<const double> y, const Ends& ends);
  /// Values of the images, behind those of the particles.
  template <typename Real>
  void CopyToImages(std::vector<Real>& values) const;
  /// Density of the block's particles.
  virtual void ComputeDensities(ListBlock& block);
  /// What else a derived solver reads in its interaction, of the particles first ... last - 1, once their density is
  /// known.
  virtual void PrepareInteraction(std::size_t first, std::size_t last);
  /// Calls work(block) for every block of lists, on all threads: those of the particles, or others.
  template <typename Work>
  void ForEachBlock(Work work) {
    ForEach(neighbours_.Blocks(), work);
  }
  template <typename Work>
  void ForEach(std::vector<ListBlock>& blocks, Work work);
  /// Completes what neighbours read once PrepareInteraction is done for all: the images' values.
  virtual void PrepareImages();
  /// The particles of a block: first ... last - 1.
  std::pair<std::size_t, std::size_t> ParticlesOf(const ListBlock& block) const;
  template <typename Real>
  PassInput<Real> InputOf(const FluidArrays<Real>& fluid) const;

  NeighbourSearch neighbours_;  // the neighbour store
  AnyFluidArrays fluid_;

 private:
  double FastestSound() const;  // [m/s]
  void WrapPositions();

  std::vector<double> extra_x_, extra_y_;  // of images and wall particles [m]

  ParametersSPH initial_parameters_sph_;
};

template <typename Work>
void ParticleSystemSPH::ForEach(std::vector<ListBlock>& blocks, Work work) {
  constexpr std::size_t kBlocksOfOneThread = 3;  // waking the others costs more than so little work
  ShareOut(blocks.size(), blocks.size() > kBlocksOfOneThread ? ThreadCount() : 1,
           [&](std::size_t block) { work(blocks[block]); });
}

template <typename Real>
void ParticleSystemSPH::CopyToImages(std::vector<Real>& values) const {
  const auto sources = neighbours_.AllImages().Sources();
  for (std::size_t k = 0; k < sources.size(); ++k) values[particles_.Size() + k] = values[sources[k]];
}

template <typename Real>
PassInput<Real> ParticleSystemSPH::InputOf(const FluidArrays<Real>& fluid) const {
  const double equal_mass = particles_.Size() == 0 ? 0 : particles_.mass[0];
  return {&fluid.positions, Support(), fluid.Masses(), equal_mass, neighbours_.Clusters()};
}

}  // namespace sph
