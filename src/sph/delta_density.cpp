// How a liquid's densities keep to its motion: continuity and diffusion, shifts, and the room that particles have.
#include <algorithm>
#include <atomic>

#include "sph/delta.hpp"

namespace sph {

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
  constexpr double kSureOfIt = 0.9;
  const double share = std::min(0.1, LastStep() * kRate * Sound() / Support());
  std::visit(
      [&]<typename Real>(const Arrays<Real>& arrays) {
        ForEachChunk([&](std::size_t, std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            if (arrays.concentration[i] == 0 || arrays.next_wholeness[i] < Real(kSureOfIt)) continue;
            density_[i] *= 1 + share * (static_cast<double>(arrays.concentration[i]) / lattice_.concentration - 1);
          }
        });
      },
      arrays_);
}

}  // namespace sph
