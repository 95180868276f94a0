#include "sph/delta.hpp"

#include <algorithm>

namespace sph {

Delta::Delta(const Parameters& base, const ParametersSPH& sph) : ParticleSystemSPH(base, sph) {
  if (sph.precision == Precision::kDouble) arrays_ = Arrays<double>();
}

std::string Delta::KernelName() const {
  return parameters_sph.delta.kernel == WendlandKernel::kC2 ? "Wendland C2" : "Wendland C4";
}

double Delta::Sound() const {
  return std::visit([&](const auto& equation) { return equation.SoundSpeed(Rho0()); },
                    parameters_sph.equation_of_state);
}

void Delta::InitialPositions() {
  ParticleSystemSPH::InitialPositions();
  const Particles& p = particles_;
  density_.assign(p.Size(), Rho0());
  if (!IsGas()) {
    for (std::size_t i = 0; i < p.Size(); ++i) {
      const double pressure = FlowAt(p.Position(i)).pressure;
      density_[i] = std::visit([&](const auto& equation) { return equation.Density(pressure); },
                               parameters_sph.equation_of_state);
    }
  }
  density_step_ = -1;
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
  const std::size_t old = density_.size();
  density_.resize(order.size(), Rho0());  // of a block that was dropped
  apply(density_);
  std::visit(
      [&](auto& arrays) {
        for (auto* values : {&arrays.gradient_x, &arrays.gradient_y, &arrays.wholeness}) {
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
      [&](auto& fluid) {
        ComputeWendlandDensity(parameters_sph.delta.kernel, InputOf(fluid), block, fluid.density.data());
      },
      fluid_);
}

void Delta::AddSpatialInteraction(const ListBlock& block) {
  std::visit(
      [&](auto& fluid) {
        AddWendlandPressure(parameters_sph.delta.kernel, InputOf(fluid), block, fluid.pressure_term.data(),
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
          .viscosity = parameters_sph.viscosity,
          .artificial = delta.artificial_viscosity * h_c * Rho0(),
          .spacing = InitialSpacing(),
          .sharp_gradient = delta.sharp_gradient,
          .tensile_control = delta.tensile_control};
}

namespace {

bool Mirrored(ImageOf image) { return image == ImageOf::kMirrorLow || image == ImageOf::kMirrorHigh; }

/// Velocity of the walls that bound the fluid on this side [m/s].
double WallVelocity(std::span<const Wall> walls, ImageOf image, bool vertical) {
  const FluidSide side = vertical ? (image == ImageOf::kMirrorLow ? FluidSide::kRight : FluidSide::kLeft)
                                  : (image == ImageOf::kMirrorLow ? FluidSide::kAbove : FluidSide::kBelow);
  const auto found = std::ranges::find(walls, side, &Wall::fluid);
  return found == walls.end() ? 0 : found->velocity;
}

}  // namespace

template <typename Real>
void Delta::CopyVelocitiesToImages(Arrays<Real>& arrays) const {
  const Images& images = neighbours_.AllImages();
  const std::size_t n = particles_.Size();
  const Ends& ends = neighbours_.CurrentEnds();
  const Particles& p = particles_;
  const bool sticks = parameters.wall.no_slip;
  const double mu = parameters_sph.viscosity;
  const double c2 = Sound() * Sound();
  // A velocity along the wall. Turned round alone, its profile would have a kink in its second derivative there, which
  // is -(rho g - grad p)/mu: nothing accelerates at the wall.
  const auto along = [&](double v, std::size_t i, double depth, double gravity, double gradient) {
    if (!sticks) return v;
    return mu > 0 ? -v - (density_[i] * gravity - c2 * gradient) / mu * depth * depth : -v;
  };
  const auto depth = [](const AxisEnds& axis, ImageOf image, double at) {
    return image == ImageOf::kMirrorLow ? at - axis.low : axis.high - at;
  };
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    double vx = static_cast<double>(arrays.vx[i]), vy = static_cast<double>(arrays.vy[i]);
    if (const ImageOf image = images.InX()[k]; Mirrored(image)) {
      vx = 2 * WallVelocity(parameters.walls, image, true) - vx;
      vy = along(vy, i, depth(ends.x, image, p.x[i]), parameters.gravity.y, static_cast<double>(arrays.gradient_y[i]));
    }
    if (const ImageOf image = images.InY()[k]; Mirrored(image)) {
      vy = 2 * WallVelocity(parameters.walls, image, false) - vy;
      vx = along(vx, i, depth(ends.y, image, p.y[i]), parameters.gravity.x, static_cast<double>(arrays.gradient_x[i]));
    }
    arrays.vx[n + k] = static_cast<Real>(vx);
    arrays.vy[n + k] = static_cast<Real>(vy);
  }
}

template <typename Real>
void Delta::CopyGradientToImages(Arrays<Real>& arrays) const {
  const Images& images = neighbours_.AllImages();
  const std::size_t n = particles_.Size();
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    // The part of the fluid's weight goes on behind a mirror as before it.
    const double weight = density_[i] / (Sound() * Sound());
    const auto turned = [&](ImageOf image, Real value, double gravity) {
      return Mirrored(image) ? static_cast<Real>(2 * weight * gravity) - value : value;
    };
    arrays.gradient_x[n + k] = turned(images.InX()[k], arrays.gradient_x[i], parameters.gravity.x);
    arrays.gradient_y[n + k] = turned(images.InY()[k], arrays.gradient_y[i], parameters.gravity.y);
  }
}

template <typename Real>
void Delta::CopyPressureToImages(Arrays<Real>& arrays) const {
  const Images& images = neighbours_.AllImages();
  const Particles& p = particles_;
  const Ends& ends = neighbours_.CurrentEnds();
  const double per_c2 = 1 / (Sound() * Sound());
  /// From a particle to its image [m]; 0 where that is no mirror's.
  const auto across = [](const AxisEnds& axis, ImageOf image, double at) {
    if (image == ImageOf::kMirrorLow) return 2 * (axis.low - at);
    return image == ImageOf::kMirrorHigh ? 2 * (axis.high - at) : 0.0;
  };
  for (std::size_t k = 0; k < images.Size(); ++k) {
    const std::uint32_t i = images.Sources()[k];
    const Vec2 apart{across(ends.x, images.InX()[k], p.x[i]), across(ends.y, images.InY()[k], p.y[i])};
    const double weight = density_[i] * Dot(parameters.gravity, apart);  // [Pa]
    arrays.pressure[p.Size() + k] = arrays.pressure[i] + static_cast<Real>(weight);
    arrays.excess[p.Size() + k] = arrays.excess[i] + static_cast<Real>(weight * per_c2);
  }
}

/// From the last step's time to this one's, by the rates halfway between.
void Delta::AdvanceDensity() {
  const PhaseTimer timer(phases_, "density");
  const Particles& p = particles_;
  const double dt = LastStep();
  const double rho0 = Rho0();
  mid_x_.resize(p.Size());
  mid_y_.resize(p.Size());
  std::visit(
      [&]<typename Real>(const FluidArrays<Real>& fluid) {
        auto& arrays = std::get<Arrays<Real>>(arrays_);
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            mid_x_[i] = p.x[i] - 0.5 * dt * p.vx_prev[i];
            mid_y_[i] = p.y[i] - 0.5 * dt * p.vy_prev[i];
            arrays.vx[i] = static_cast<Real>(p.vx_prev[i]);
            arrays.vy[i] = static_cast<Real>(p.vy_prev[i]);
            arrays.volume[i] = static_cast<Real>(p.mass[i] / density_[i]);
            arrays.excess[i] = static_cast<Real>(density_[i] - rho0);
          }
        });
        SetPositions(mid_x_, mid_y_);
        CopyToImages(arrays.volume);
        CopyVelocitiesToImages(arrays);
        CopyGradientToImages(arrays);
        CopyPressureToImages(arrays);
        ForEachBlock([&](const ListBlock& block) {
          ComputeDensityRates(InputOf(fluid), WaterOf(arrays), block, arrays.rate.data());
          const auto [first, last] = ParticlesOf(block);
          for (std::size_t i = first; i < last; ++i) density_[i] += dt * static_cast<double>(arrays.rate[i]);
        });
      },
      fluid_);
  SetPositions(p.x, p.y);
}

void Delta::ComputeForces() {
  const PhaseTimer timer(phases_, "pressure");
  Particles& p = particles_;
  const double rho0 = Rho0();
  std::visit(
      [&]<typename Real>(FluidArrays<Real>& fluid, const auto& equation_of_state) {
        auto& arrays = std::get<Arrays<Real>>(arrays_);
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            arrays.volume[i] = static_cast<Real>(p.mass[i] / density_[i]);
            arrays.excess[i] = static_cast<Real>(density_[i] - rho0);
            arrays.pressure[i] = static_cast<Real>(equation_of_state.Pressure(density_[i]));
            arrays.vx[i] = static_cast<Real>(p.vx[i]);
            arrays.vy[i] = static_cast<Real>(p.vy[i]);
            fluid.density[i] = static_cast<Real>(density_[i]);
          }
        });
        CopyToImages(arrays.volume);
        CopyToImages(arrays.wholeness);
        CopyVelocitiesToImages(arrays);
        CopyPressureToImages(arrays);
        const WaterSums<Real> sums{arrays.gradient_x.data(), arrays.gradient_y.data(), arrays.next_wholeness.data(),
                                   arrays.shift_x.data(), arrays.shift_y.data()};
        ForEachBlock([&](ListBlock& block) {
          const auto [first, last] = ParticlesOf(block);
          ClearAccelerations(first, last);
          AddWaterForces(InputOf(fluid), WaterOf(arrays), block, p.ax.data(), p.ay.data(), sums);
          AddGravity(first, last);
          AddMotionDamping(first, last);
        });
      },
      fluid_, parameters_sph.equation_of_state);
}

/// Shifts particles towards where they are missing: by -CFL Ma (2h)^2 sum [...] grad W 2 m_j/(rho_i + rho_j)
/// [Sun et al. 2017, eq. 7], that is -dt 4 h u_max sum, and by a twentieth of a spacing at most.
void Delta::AfterStep() {
  if (IsGas() || !parameters_sph.delta.shifting) return;
  Particles& p = particles_;
  const double longest = 0.05 * InitialSpacing();
  const double factor = 4 * parameters_sph.smoothing_length * LastTravel();
  double furthest2 = 0;
  std::visit(
      [&](const auto& arrays) {
        for (std::size_t i = 0; i < p.Size(); ++i) {
          Vec2 shift = -factor * Vec2{static_cast<double>(arrays.shift_x[i]), static_cast<double>(arrays.shift_y[i])};
          const double length = Length(shift);
          if (length > longest) shift = longest / length * shift;
          p.x[i] += shift.x;
          p.y[i] += shift.y;
          furthest2 = std::max(furthest2, Dot(shift, shift));
        }
      },
      arrays_);
  AddTravel(std::sqrt(furthest2));
}

/// 2/max(K h W(K)) of the kernel's Fourier transform for a liquid; for a gas with P = rho c^2/2 less.
double Delta::StableSoundStep() const {
  if (parameters_sph.delta.kernel == WendlandKernel::kC2) return IsGas() ? 1.25 : 1.76;
  return IsGas() ? 1.09 : 1.53;
}

std::vector<StepLimit> Delta::StepLimits() const {
  std::vector<StepLimit> limits = ParticleSystemSPH::StepLimits();
  if (IsGas()) return limits;
  // 2/max(2 sum V (-W'/r)(1 - cos k.x)) over the waves on a square lattice, in units of h^2: of the plain weights, with
  // which density spreads, and of the sharp ones of the viscous force; the least of h/dx from 1.6 to 2.8.
  const bool c2 = parameters_sph.delta.kernel == WendlandKernel::kC2;
  const double plain = c2 ? 0.29 : 0.22;
  const double sharp = c2 ? 0.126 : 0.102;
  const double h = parameters_sph.smoothing_length;
  const double spreading = parameters_sph.delta.diffusion * h * Sound();
  if (spreading > 0) limits.push_back({"density diffusion", plain * h * h / spreading});
  const double nu = parameters_sph.viscosity / Rho0();
  // Half of that, because the velocity at the step is extrapolated from two half steps (Adams-Bashforth).
  if (nu > 0) limits.push_back({"viscosity", 0.5 * sharp * h * h / nu});
  return limits;
}

std::size_t Delta::Bytes() const {
  const std::size_t own = sizeof(double) * (density_.capacity() + mid_x_.capacity() + mid_y_.capacity());
  return ParticleSystemSPH::Bytes() + own +
         std::visit(
             []<typename Real>(const Arrays<Real>& arrays) { return sizeof(Real) * 12 * arrays.volume.capacity(); },
             arrays_);
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
  return plan;
}

}  // namespace sph
