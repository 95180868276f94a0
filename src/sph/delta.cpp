#include "sph/delta.hpp"

#include <algorithm>

namespace sph {

Delta::Delta(const Parameters& base, const ParametersSPH& sph)
    : ParticleSystemSPH(base, sph),
      lattice_(
          SumsOnLattices(sph.delta.kernel, SupportOf(sph.delta.kernel) * sph.smoothing_length / InitialSpacing())) {
  if (sph.precision == Precision::kDouble) {
    arrays_ = Arrays<double>();
    surface_ = SurfaceArrays<double>();
    wall_values_ = WallValues<double>();
  }
}

double Delta::Sound() const {
  return std::visit([&](const auto& equation) { return equation.SoundSpeed(Rho0()); },
                    parameters_sph.equation_of_state);
}

void Delta::InitialPositions() {
  ParticleSystemSPH::InitialPositions();
  const Particles& p = particles_;
  density_.assign(p.Size(), Rho0());
  if (parameters.given != nullptr) {
    if (const std::vector<double>& given = parameters.given->density; given.size() == p.Size()) density_ = given;
  } else if (!IsGas()) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double pressure = FlowAt(p.Position(i)).pressure;
      density_[i] = std::visit([&](const auto& equation) { return equation.Density(pressure); },
                               parameters_sph.equation_of_state);
    }
  }
  density_step_ = -1;
  density_in_order_ = true;
  std::visit(
      [](auto& arrays) {
        for (auto* values : arrays.All()) values->clear();
      },
      arrays_);
}

void Delta::Reorder(std::span<const std::uint32_t> order) {
  ParticleSystemSPH::Reorder(order);
  if (IsGas()) return;
  const auto apply = [&](auto& values) {
    auto sorted = values;
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[order[k]];
    values.swap(sorted);
  };
  std::visit([](auto& arrays) { std::ranges::fill(arrays.rate, 0); }, arrays_);  // of other particles
  const std::size_t old = density_.size();
  density_.resize(order.size(), Rho0());  // of a block that was dropped
  apply(density_);
  std::visit(
      [&](auto& arrays) {
        for (auto* values : arrays.Kept()) {
          values->resize(std::min(values->size(), old));  // no images
          values->resize(order.size());
          apply(*values);
        }
      },
      arrays_);
}

void Delta::ResizeArrays(std::size_t n) {
  ParticleSystemSPH::ResizeArrays(n);
  if (IsGas()) return;
  std::visit(
      [n](auto& arrays) {
        for (auto* values : arrays.All()) values->resize(n + kPadding);
      },
      arrays_);
}

void Delta::ComputeDensities(ListBlock& block) {
  std::visit(
      [&](auto& fluid) { ComputeGasDensity(parameters_sph.delta.kernel, InputOf(fluid), block, fluid.density.data()); },
      fluid_);
}

void Delta::AddSpatialInteraction(const ListBlock& block) {
  std::visit(
      [&](auto& fluid) {
        AddGasPressure(parameters_sph.delta.kernel, InputOf(fluid), block, fluid.pressure_term.data(),
                       particles_.ax.data(), particles_.ay.data());
      },
      fluid_);
}

void Delta::ComputeAccelerations() {
  if (IsGas()) return ParticleSystemSPH::ComputeAccelerations();
  const auto turn_over = [&] {
    std::visit([](auto& arrays) { arrays.wholeness.swap(arrays.next_wholeness); }, arrays_);
  };
  const bool fresh = density_step_ < 0;
  const bool stepped = !fresh && density_step_ != Steps();
  // Only once a step, so that who looks at the fields again finds the same and changes nothing.
  if (stepped) turn_over();
  PrepareGrid();
  density_.resize(particles_.Size(), Rho0());
  if (stepped) AdvanceDensity();
  density_step_ = Steps();
  ComputeForces();
  if (!fresh) return;
  turn_over();  // the first forces did not know where the surface is
  ComputeForces();
}

template <typename Real>
WaterInput<Real> Delta::WaterOf(const Arrays<Real>& arrays) const {
  const DeltaParameters& delta = parameters_sph.delta;
  const double h_c = parameters_sph.smoothing_length * Sound();
  // An artificial viscosity of alpha h c is a kinematic one of an eighth of that in the plane [Monaghan 2005, eq. 8.8].
  const double mu = parameters_sph.viscosity;
  const bool stress = delta.viscous_form == ViscousForm::kStress;
  const KernelProperties& kernel = PropertiesOf(delta.kernel);
  return {.kernel = delta.kernel,
          .volume = arrays.volume.data(),
          .excess = arrays.excess.data(),
          .pressure = arrays.pressure.data(),
          .vx = arrays.vx.data(),
          .vy = arrays.vy.data(),
          .gradient_x = arrays.gradient_x.data(),
          .gradient_y = arrays.gradient_y.data(),
          .wholeness = arrays.wholeness.data(),
          .strain = arrays.strain.data(),
          .sound = Sound(),
          .rho0 = Rho0(),
          .diffusion = delta.diffusion * h_c,
          .viscosity = stress ? 0 : mu,
          .artificial = delta.artificial_viscosity * h_c * Rho0() + (stress ? 8 * mu : 0),
          .spacing = InitialSpacing(),
          .variance = kernel.variance * Support() * Support(),
          .gradient_flat = delta.sharp_gradient ? kernel.flat / lattice_.fourth_order : 1 / lattice_.second_order,
          .gradient_fall = delta.sharp_gradient ? kernel.fall / lattice_.fourth_order : 0,
          .tensile_control = delta.tensile_control};
}

void Delta::ComputeForces() {
  ComputeWaterForces();
  if (HasTension()) AddTension();
}

void Delta::ComputeWaterForces() {
  const PhaseTimer timer(phases_, "pressure");
  Particles& p = particles_;
  const double rho0 = Rho0();
  // -zeta div u with the bulk viscosity zeta = alpha h c rho0, div u being -(drho/dt)/rho0, damps sound and nothing
  // else [P. N. Sun et al., J. Comput. Phys. 483 (2023) 112056].
  const double damping = parameters_sph.delta.sound_damping * parameters_sph.smoothing_length * Sound();
  std::visit(
      [&]<typename Real>(FluidArrays<Real>& fluid, const auto& equation_of_state) {
        auto& arrays = std::get<Arrays<Real>>(arrays_);
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            arrays.volume[i] = static_cast<Real>(p.mass[i] / density_[i]);
            arrays.excess[i] = static_cast<Real>(density_[i] - rho0);
            arrays.pressure[i] = static_cast<Real>(equation_of_state.Pressure(density_[i]) +
                                                   damping * static_cast<double>(arrays.rate[i]));
            arrays.vx[i] = static_cast<Real>(p.vx[i]);
            arrays.vy[i] = static_cast<Real>(p.vy[i]);
            fluid.density[i] = static_cast<Real>(density_[i]);
          }
        });
        CopyToImages(arrays.volume);
        CopyToImages(arrays.wholeness);
        const SideVelocities sides = SideVelocities::ForForces(parameters.walls, parameters.wall, Time());
        CopyVelocitiesToImages(arrays, sides);
        CopyPressureToImages(arrays);
        SetWallParticles(fluid, arrays, sides);
        const WaterSums<Real> sums{arrays.gradient_x.data(), arrays.gradient_y.data(), arrays.next_wholeness.data(),
                                   arrays.shift_x.data(),    arrays.shift_y.data(),    arrays.concentration.data()};
        ForEachBlock([&](ListBlock& block) {
          const auto [first, last] = ParticlesOf(block);
          ClearAccelerations(first, last);
          AddWaterForces(InputOf(fluid), WaterOf(arrays), block, p.ax.data(), p.ay.data(), sums);
          AddGravity(first, last);
          AddMotionDamping(first, last);
          AddWallFriction(first, last);
        });
      },
      fluid_, parameters_sph.equation_of_state);
}

void Delta::AddTension() {
  const PhaseTimer timer(phases_, "surface tension");
  Particles& p = particles_;
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid) {
        const Real* const volume = std::get<Arrays<Real>>(arrays_).volume.data();
        auto& surface = std::get<SurfaceArrays<Real>>(surface_);
        for (auto* values : surface.All()) values->resize(p.Size() + neighbours_.Extras() + kPadding);
        ForEachBlock([&](const ListBlock& block) { ComputeSurface(InputOf(fluid), volume, block, surface); });
        CopyVectorToImages(surface.normal_x, surface.normal_y);
        CopyToImages(surface.weight);
        const std::size_t walls = p.Size() + neighbours_.AllImages().Size();  // they have no surface
        std::fill(surface.weight.begin() + static_cast<std::ptrdiff_t>(walls), surface.weight.end(), 0);
        const SurfaceInput<Real> input{parameters_sph.delta.kernel, &surface, volume, fluid.density.data(),
                                       parameters_sph.delta.surface_tension};
        ForEachBlock(
            [&](const ListBlock& block) { AddSurfaceTension(InputOf(fluid), input, block, p.ax.data(), p.ay.data()); });
      },
      fluid_);
}

/// What a turbulent boundary layer takes from the particles beside a wall, which stand for a layer one spacing thick
/// and are half of one away from it: a shear stress of rho u*^2 with u/u* = 8.3 (u* y/nu)^(1/7) at the distance y [H.
/// Werner and H. Wengle, Turbulent Shear Flows 8 (1993) 155, the 1/7 power law].
void Delta::AddWallFriction(std::size_t first, std::size_t last) {
  const double nu = parameters.wall.layer_viscosity;
  if (nu == 0 || !parameters.wall.SeenByFluid()) return;
  Particles& p = particles_;
  const double spacing = InitialSpacing();
  const double layer = std::pow(2 * nu / spacing, 0.25) / spacing;
  for (const Wall* wall : BoundingWalls(parameters.walls).All()) {
    if (wall == nullptr || Sticks(*wall, parameters.wall)) continue;
    const auto& velocity = wall->Vertical() ? p.vy : p.vx;
    auto& acceleration = wall->Vertical() ? p.ay : p.ax;
    for (std::size_t i = first; i < last; ++i) {
      if (wall->Depth(p.Position(i)) < -spacing) continue;
      const double stress = layer * std::pow(std::abs(velocity[i]) / 8.3, 1.75);
      acceleration[i] -= std::copysign(stress, velocity[i]);
    }
  }
}

std::size_t Delta::Bytes() const {
  const std::size_t own = sizeof(double) * (density_.capacity() + mid_x_.capacity() + mid_y_.capacity());
  return ParticleSystemSPH::Bytes() + own +
         std::visit(
             []<typename Real>(const Arrays<Real>& arrays, const auto& surface, const auto& walls) {
               return sizeof(Real) * (14 * arrays.volume.capacity() + 5 * surface.weight.capacity()) + walls.Bytes();
             },
             arrays_, surface_, wall_values_);
}

std::vector<Vec2> Delta::DensityGradient() const {
  std::vector<Vec2> gradient(particles_.Size());
  const auto copy = [&](const auto& arrays) {
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] = {arrays.gradient_x[i], arrays.gradient_y[i]};
  };
  std::visit(copy, arrays_);
  return gradient;
}

void Delta::Transfer(Archive& archive) {
  ParticleSystemSPH::Transfer(archive);
  if (IsGas()) return;
  archive(density_, density_step_);
  Archive::Require(density_.size() == particles_.Size());
  std::visit(
      [&](auto& arrays) {
        for (auto* values : arrays.Kept()) archive(*values);
        archive(arrays.next_wholeness, arrays.rate);
      },
      arrays_);
  if (!archive.Reading()) return;
  density_in_order_ = true;
  ResizeArrays(particles_.Size() + neighbours_.Extras());
}

std::vector<PassPlan> Delta::Plan() const {
  std::vector<PassPlan> plan = ParticleSystemSPH::Plan();
  const DeltaParameters& delta = parameters_sph.delta;
  for (PassPlan& pass : plan) {
    if (pass.name == "density") {
      pass.reason =
          IsGas() ? "density by summation, and pressure" : "continuity and density diffusion, at the half step";
    }
    if (pass.name == "pressure" && !IsGas()) {
      pass.reason = fmt::format("pressure{}{}, and what diffusion and shifting need, in one pass",
                                parameters_sph.viscosity != 0 ? ", viscosity" : "",
                                delta.artificial_viscosity != 0 ? ", artificial viscosity" : "");
    }
  }
  const bool shifts = !IsGas() && delta.shifting;
  plan.push_back({"shifting", shifts,
                  shifts    ? "particles go where they lack"
                  : IsGas() ? "a gas fills gaps by itself"
                            : "shifting is off"});
  plan.push_back({"surface tension", HasTension(),
                  HasTension() ? "the surface gets shorter"
                  : IsGas()    ? "a gas has no surface"
                               : "sigma is 0"});
  return plan;
}

template WaterInput<float> Delta::WaterOf(const Arrays<float>&) const;
template WaterInput<double> Delta::WaterOf(const Arrays<double>&) const;

}  // namespace sph
