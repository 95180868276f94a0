// What ParticleSystem::Draw draws on: an abstract surface, so that the physics knows no screen.
#pragma once

#include <span>

#include "base/vec2.hpp"

namespace sph {

/// What the disks are coloured by.
enum class Colouring { kBlackDisks, kSpeed, kPressure, kDensity };

class Canvas {
 public:
  virtual ~Canvas() = default;

  /// The quantity that the next DrawDisks shows; it decides whether that call needs values.
  virtual Colouring WantedColouring() const = 0;

  /// A disk of `radius` [m] at each (x[i], y[i]) [m]. values[i] is the wanted quantity in SI units; empty for black
  /// disks. All three spans are as long as there are particles, or `values` is empty; they are read before the call
  /// returns.
  virtual void DrawDisks(std::span<const double> x, std::span<const double> y, double radius,
                         std::span<const double> values) = 0;

  /// A wall seen from its edge: the segment from a to b [m].
  virtual void DrawWall(Vec2 a, Vec2 b) = 0;
};

}  // namespace sph
