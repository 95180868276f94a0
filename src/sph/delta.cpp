#include "sph/delta.hpp"

#include <algorithm>
#include <atomic>

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

/// From the last step's time to this one's, by the rates halfway between.
void Delta::AdvanceDensity() {
  const PhaseTimer timer(phases_, "density");
  const Particles& p = particles_;
  const double dt = density_span_ = LastStep();
  const double rho0 = Rho0();
  std::atomic<bool> breached = false;
  mid_x_.resize(p.Size());
  mid_y_.resize(p.Size());
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid) {
        auto& arrays = std::get<Arrays<Real>>(arrays_);
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            const Vec2 shift{static_cast<double>(arrays.shift_x[i]), static_cast<double>(arrays.shift_y[i])};
            const Vec2 gradient{static_cast<double>(arrays.gradient_x[i]), static_cast<double>(arrays.gradient_y[i])};
            mid_x_[i] = p.x[i] - 0.5 * (dt * p.vx_prev[i] + shift.x);
            mid_y_[i] = p.y[i] - 0.5 * (dt * p.vy_prev[i] + shift.y);
            arrays.vx[i] = static_cast<Real>(p.vx_prev[i]);
            arrays.vy[i] = static_cast<Real>(p.vy_prev[i]);
            const double gain = Dot(shift, gradient);
            const double halfway = density_[i] + 0.5 * gain;
            density_[i] += gain;
            arrays.volume[i] = static_cast<Real>(p.mass[i] / halfway);
            arrays.excess[i] = static_cast<Real>(halfway - rho0);
          }
        });
        SetPositions(mid_x_, mid_y_, EndsBefore(0.5 * dt));
        const SideVelocities sides = SideVelocities::ForDensity(parameters.walls, 0.5 * dt);
        CopyToImages(arrays.volume);
        CopyVelocitiesToImages(arrays, sides);
        CopyGradientToImages(arrays);
        CopyPressureToImages(arrays);
        SetWallParticles(fluid, arrays, sides);
        ForEachBlock([&](const ListBlock& block) {
          ComputeDensityRates<Real>(InputOf(fluid), WaterOf(arrays), block, {arrays.rate.data(), arrays.strain.data()});
          const auto [first, last] = ParticlesOf(block);
          bool in_order = true;
          for (std::size_t i = first; i < last; ++i) {
            in_order = in_order && InOrder(density_[i] + dt * static_cast<double>(arrays.rate[i]));
          }
          if (!in_order) breached.store(true, std::memory_order_relaxed);
        });
        if (breached) return;  // FindBreach says of which particle
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) density_[i] += dt * static_cast<double>(arrays.rate[i]);
        });
      },
      fluid_);
  SetPositions(p.x, p.y, neighbours_.CurrentEnds());
  density_in_order_ = !breached;
}

/// The density of a weakly compressible liquid stays within some per cent of the reference.
bool Delta::InOrder(double density) const { return density > 0.5 * Rho0() && density < 2 * Rho0(); }

std::optional<ParticleSystem::Breach> Delta::FindBreach() const {
  if (density_in_order_) return std::nullopt;
  std::optional<std::size_t> first;
  double of_first = 0;  // [kg/m^3]
  std::visit(
      [&](const auto& arrays) {
        for (std::size_t i = 0; i < density_.size(); ++i) {
          const double density = density_[i] + density_span_ * static_cast<double>(arrays.rate[i]);
          if (InOrder(density) || (first && particles_.id[i] > particles_.id[*first])) continue;
          first = i;
          of_first = density;
        }
      },
      arrays_);
  return Breach{first.value(),
                fmt::format("its density of {:.4g} kg/m^3 is {:.3g} times that of the liquid at rest; the "
                            "step was {:.3g} s",
                            of_first, of_first / Rho0(), parameters.time_step)};
}

std::optional<ParticleSystem::Breach> Delta::FindBrokenStart() const {
  if (auto breach = ParticleSystemSPH::FindBrokenStart()) return breach;
  for (std::size_t i = 0; i < density_.size(); ++i) {
    if (IsGas() || InOrder(density_[i])) continue;
    return Breach{i, fmt::format("its density at the start, {:.4g} kg/m^3, is {:.3g} times that of the liquid at rest",
                                 density_[i], density_[i] / Rho0())};
  }
  return std::nullopt;
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
                                   arrays.shift_x.data(),    arrays.shift_y.data(),    arrays.concentration.data(),
                                   arrays.covered.data()};
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

void Delta::AfterStep() {
  if (IsGas()) return;
  TieDensity();
  Shift();
}

/// Shifts particles towards where they are missing, as Sun et al. do [2017, eq. 7], but with another speed: disorder
/// comes of the strain, so that they go by -dt K S R^2 sum. As fast as fluid a support away moves against them [as in
/// J. Michel et al., J. Comput. Phys. 459 (2022) 110999, eq. 20], this vanishes with the spacing, and in water at rest.
/// A twentieth of a spacing at most.
void Delta::Shift() {
  const double strength = parameters_sph.delta.shifting ? 7 : 0;
  Particles& p = particles_;
  const double longest = 0.05 * InitialSpacing();
  const double factor = strength * Support() * Support() * LastStep();
  std::visit(
      [&]<typename Real>(Arrays<Real>& arrays) {
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            const Vec2 sum{static_cast<double>(arrays.shift_x[i]), static_cast<double>(arrays.shift_y[i])};
            Vec2 shift = -factor * static_cast<double>(arrays.strain[i]) * sum;
            const double square = Dot(shift, shift);
            if (square > longest * longest) shift = longest / std::sqrt(square) * shift;
            p.x[i] += shift.x;
            p.y[i] += shift.y;
            arrays.shift_x[i] = static_cast<Real>(shift.x);
            arrays.shift_y[i] = static_cast<Real>(shift.y);
          }
        });
      },
      arrays_);
}

/// A particle's mass stays what it was, so that its density follows from how much room the others leave it; the
/// continuity equation knows that to second order, and in time the errors add up: water in disorder sinks, while its
/// densities say that it fills the tank. So inside, where sum V W can tell, densities follow it slowly: by a part k of
/// the difference in the time that sound takes through a support. The sound that this makes is that small.
void Delta::TieDensity() {
  constexpr double kRate = 0.002;  // k
  constexpr double kInside = 0.75, kSureOfIt = 0.9;
  const double share = std::min(0.1, LastStep() * kRate * Sound() / Support());
  std::visit(
      [&]<typename Real>(const Arrays<Real>& arrays) {
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            if (arrays.covered[i] < Real(kInside) || arrays.next_wholeness[i] < Real(kSureOfIt)) continue;
            density_[i] *= 1 + share * (static_cast<double>(arrays.concentration[i]) / lattice_.concentration - 1);
          }
        });
      },
      arrays_);
}

std::size_t Delta::Bytes() const {
  const std::size_t own = sizeof(double) * (density_.capacity() + mid_x_.capacity() + mid_y_.capacity());
  return ParticleSystemSPH::Bytes() + own +
         std::visit(
             []<typename Real>(const Arrays<Real>& arrays, const auto& surface, const auto& walls) {
               return sizeof(Real) * (15 * arrays.volume.capacity() + 5 * surface.weight.capacity()) + walls.Bytes();
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

}  // namespace sph
