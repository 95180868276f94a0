#include "sph/particle_system_sph.hpp"

#include <algorithm>

#include "sph/density_summation.hpp"
#include "sph/pressure_acceleration.hpp"

namespace sph {

ParticleSystemSPH::ParticleSystemSPH(const Parameters& base, const ParametersSPH& sph)
    : ParticleSystem(base), parameters_sph(sph), initial_parameters_sph_(sph) {
  SPH_CHECK(sph.smoothing_length > 0, "h = {}", sph.smoothing_length);
}

void ParticleSystemSPH::RestoreParameters() {
  ParticleSystem::RestoreParameters();
  parameters_sph = initial_parameters_sph_;
}

void ParticleSystemSPH::ComputeAccelerations() {
  ComputePressures();
  std::fill(particles_.ax.begin(), particles_.ax.end(), 0.0);
  std::fill(particles_.ay.begin(), particles_.ay.end(), 0.0);
  AddSpatialInteraction();
  AddGravity();
  AddMotionDamping();
}

void ParticleSystemSPH::PrepareGrid() {
  const PhaseTimer timer(phases_, "grid");
  grid_.Build(particles_.x, particles_.y, Support());
  if (!grid_.InOrder()) particles_.Reorder(grid_.Order());
}

void ParticleSystemSPH::ComputeDensities(const NeighbourBlock& block) {
  ComputeDensity(block, CubicSpline<2>(parameters_sph.smoothing_length), particles_.mass, density_);
}

void ParticleSystemSPH::ComputePressures() {
  PrepareGrid();
  const PhaseTimer timer(phases_, "density");
  const std::size_t n = particles_.Size();
  for (auto* values : {&density_, &pressure_, &pressure_term_}) values->resize(n);
  neighbours_.resize((n + kParticlesPerBlock - 1) / kParticlesPerBlock);
  const double reach = Support();
  std::visit(
      [&](const auto& equation_of_state) {
        ForEachBlock([&](NeighbourBlock& block) {
          const std::size_t first = static_cast<std::size_t>(&block - neighbours_.data()) * kParticlesPerBlock;
          const std::size_t last = std::min(first + kParticlesPerBlock, n);
          block.Find(grid_, particles_.x, particles_.y, reach, first, last - first);
          ComputeDensities(block);
          for (std::size_t i = first; i < last; ++i) {
            pressure_[i] = equation_of_state.Pressure(density_[i]);
            pressure_term_[i] = pressure_[i] / (density_[i] * density_[i]);
          }
        });
      },
      parameters_sph.equation_of_state);
}

void ParticleSystemSPH::AddSpatialInteraction() {
  const PhaseTimer timer(phases_, "pressure");
  const CubicSpline<2> kernel(parameters_sph.smoothing_length);
  ForEachBlock([&](const NeighbourBlock& block) {
    AddPressureAcceleration(block, kernel, particles_.x, particles_.y, particles_.mass, pressure_term_, particles_.ax,
                            particles_.ay);
  });
}

double ParticleSystemSPH::InternalEnergy() const {
  return std::visit(
      [&](const auto& equation_of_state) {
        double sum = 0;
        for (std::size_t i = 0; i < density_.size(); ++i) {
          sum += particles_.mass[i] * equation_of_state.InternalEnergy(density_[i]);
        }
        return sum;
      },
      parameters_sph.equation_of_state);
}

double ParticleSystemSPH::MeanNeighbours() const {
  std::size_t pairs = 0;
  for (const NeighbourBlock& block : neighbours_) pairs += block.Pairs();
  return particles_.Size() == 0 ? 0 : static_cast<double>(pairs) / static_cast<double>(particles_.Size());
}

std::vector<PassPlan> ParticleSystemSPH::Plan() const {
  std::vector<PassPlan> plan = {
      {"grid", true, fmt::format("cells of {:.4g} m, particles sorted by cell", Support())},
      {"density", true, "neighbours, density (eq. 8) and pressure"},
      {"pressure", true, "pressure acceleration (eq. 10)"},
  };
  const std::vector<PassPlan> base = ParticleSystem::Plan();
  plan.insert(plan.end(), base.begin(), base.end());
  return plan;
}

}  // namespace sph
