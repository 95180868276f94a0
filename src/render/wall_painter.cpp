#include "render/wall_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace sph {
namespace {

struct Segment {
  Vec2 a;
  Vec2 b;
};

/// The part of the segment in |x| <= half.x, |y| <= half.y, if any [Liang & Barsky 1984, ACM Trans. Graphics 3, 1]:
/// what lies far outside is cut in double precision, before float coordinates lose it.
std::optional<Segment> Clipped(const Segment& segment, Vec2 half) {
  const Vec2 direction = segment.b - segment.a;
  double from = 0;
  double to = 1;
  const auto cut = [&](double start, double change, double limit) {  // to -limit <= start + t change <= limit
    if (change == 0) return std::abs(start) <= limit;
    const auto [enter, leave] = std::minmax({(-limit - start) / change, (limit - start) / change});
    from = std::max(from, enter);
    to = std::min(to, leave);
    return from <= to;
  };
  if (!cut(segment.a.x, direction.x, half.x) || !cut(segment.a.y, direction.y, half.y)) return std::nullopt;
  return Segment{segment.a + from * direction, segment.a + to * direction};
}

/// The centre line's coordinate [pixels from the middle of the window] nearest to `coordinate` for which both edges of
/// a line of a whole number of pixels fall on pixel edges.
double Snapped(double coordinate, double line_width, int window) {
  const double first_edge = coordinate + 0.5 * window - 0.5 * line_width;
  return std::round(first_edge) - 0.5 * window + 0.5 * line_width;
}

}  // namespace

WallPainter::WallPainter(const GlFunctions& gl)
    : gl_(gl), program_(gl, "walls.vert", "walls.frag"), arrays_(gl), buffer_(gl, GL_ARRAY_BUFFER) {}

void WallPainter::Begin(const View& view, double width) {
  view_ = view;
  width_ = std::round(width);
  vertices_.clear();
}

void WallPainter::Add(Vec2 a, Vec2 b) {
  if (!std::isfinite(a.x + a.y + b.x + b.y)) return;
  const double scale = view_.Scale();
  const Vec2 centre = view_.region.Centre();
  const Vec2 half_window = {0.5 * view_.width + 2 * width_, 0.5 * view_.height + 2 * width_};
  auto segment = Clipped({scale * (a - centre), scale * (b - centre)}, half_window);
  if (!segment) return;
  if (a.x == b.x || a.y == b.y) {
    for (Vec2* end : {&segment->a, &segment->b}) {
      *end = {Snapped(end->x, width_, view_.width), Snapped(end->y, width_, view_.height)};
    }
  }

  const double length = Length(segment->b - segment->a);
  const Vec2 along = length > 0 ? (1 / length) * (segment->b - segment->a) : Vec2{1, 0};
  const Vec2 across = {-along.y, along.x};
  const Vec2 middle = 0.5 * (segment->a + segment->b);
  const double half_length = 0.5 * (length + width_);
  const double half_width = 0.5 * width_;
  const auto corner = [&](double s, double d) {
    const Vec2 at = middle + s * along + d * across;
    return Vertex{static_cast<float>(at.x), static_cast<float>(at.y),        static_cast<float>(s),
                  static_cast<float>(d),    static_cast<float>(half_length), static_cast<float>(half_width)};
  };
  const double s = half_length + 1;
  const double d = half_width + 1;
  for (const auto& [u, v] : {std::pair(-s, -d), {s, -d}, {-s, d}, {-s, d}, {s, -d}, {s, d}}) {
    vertices_.push_back(corner(u, v));
  }
}

void WallPainter::Draw() {
  if (vertices_.empty()) return;
  arrays_.Bind();
  buffer_.Upload(vertices_);
  SetAttribute(gl_, 0, 2, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, x));
  SetAttribute(gl_, 1, 2, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, along));
  SetAttribute(gl_, 2, 2, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, half_length));
  program_.Use();
  program_.Set("half_window", 0.5F * static_cast<float>(view_.width), 0.5F * static_cast<float>(view_.height));
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
}

}  // namespace sph
