// The state of a particle system: one array a component, all of the same length.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/vec2.hpp"

namespace sph {

/// Element i of every array belongs to the same particle. The order changes when a solver sorts its particles by cell;
/// `id` says which particle is where.
struct Particles {
  std::vector<double> x, y;              ///< position [m] at the current time t
  std::vector<double> vx, vy;            ///< velocity [m/s] at t, as the integrator knows it
  std::vector<double> vx_prev, vy_prev;  ///< velocity [m/s] half a step back, at t - dt/2
  std::vector<double> ax, ay;            ///< acceleration [m/s^2]
  std::vector<double> mass;              ///< [kg/m]
  std::vector<std::uint32_t> id;         ///< 0, 1, 2, ... in the order of creation

  std::size_t Size() const { return x.size(); }
  Vec2 Position(std::size_t i) const { return {x[i], y[i]}; }
  Vec2 Velocity(std::size_t i) const { return {vx[i], vy[i]}; }

  /// Makes room for n particles, and no more.
  void Reserve(std::size_t n);
  /// Appends a particle whose half-step velocity equals its velocity and whose acceleration is 0.
  void Add(Vec2 position, Vec2 velocity, double particle_mass);
  void Clear();
  /// Of all arrays.
  std::size_t Bytes() const;

  /// Element k becomes the former element order[k]. `order` is a permutation of 0 ... Size() - 1.
  void Reorder(std::span<const std::uint32_t> order, int threads = 1);

  /// All but the accelerations, which follow from the rest.
  void Transfer(Archive& archive);

 private:
  std::vector<double> scratch_;
  std::vector<std::uint32_t> id_scratch_;
};

}  // namespace sph
