// A point or vector of the plane.
#pragma once

#include <cmath>

namespace sph {

struct Vec2 {
  double x = 0;
  double y = 0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr double Dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double Length(Vec2 a) { return std::hypot(a.x, a.y); }

/// An axis-parallel rectangle [m]: x0 <= x <= x1, y0 <= y <= y1.
struct Box {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;

  constexpr double Width() const { return x1 - x0; }
  constexpr double Height() const { return y1 - y0; }
  constexpr Vec2 Centre() const { return {0.5 * (x0 + x1), 0.5 * (y0 + y1)}; }
  friend constexpr bool operator==(const Box&, const Box&) = default;
};

}  // namespace sph
