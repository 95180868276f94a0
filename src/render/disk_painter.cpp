#include "render/disk_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/check.hpp"
#include "render/tile_order.hpp"

namespace sph {
namespace {

/// The smooth edge of a disk is one pixel wide: the ink falls from 1 at distance R - 1/2 from the centre to 0 at R +
/// 1/2, and its integral over the plane is pi (R^2 + 1/12). So that it is the true disk's pi r^2, R^2 = r^2 - 1/12;
/// below R = 1/2 (r^2 = 1/3), where the ink is a cone over a circle of radius 1, the cone gets lower instead of
/// narrower.
struct Edge {
  double reach = 0;  // [pixels] R + 1/2
  double ink = 1;
};

Edge EdgeOf(double radius) {
  const double square = radius * radius;
  if (3 * square < 1) return {1, 3 * square};
  return {0.5 + std::sqrt(square - 1.0 / 12), 1};
}

Rgb ColourOf(double value, const ColourRange& range) {
  if (std::isnan(value)) return kNotANumberColour;
  return ColourAt((value - range.low) / (range.high - range.low));
}

}  // namespace

DiskPainter::DiskPainter(const GlFunctions& gl)
    : gl_(gl),
      points_(gl, "disk_points.vert", "disks.frag"),
      quads_(gl, "disk_quads.vert", "disks.frag"),
      arrays_(gl),
      buffer_(gl, GL_ARRAY_BUFFER) {
  GLfloat point_sizes[2] = {};
  gl.GetFloatv(GL_POINT_SIZE_RANGE, point_sizes);
  largest_point_ = point_sizes[1];
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, largest_viewport_);
}

void DiskPainter::Begin(const View& view) {
  view_ = view;
  batches_.clear();
  disks_.clear();
  values_.clear();
  fit_ = {};
}

void DiskPainter::Add(std::span<const double> x, std::span<const double> y, double radius,
                      std::span<const double> values) {
  SPH_CHECK(x.size() == y.size(), "{} x, {} y", x.size(), y.size());
  SPH_CHECK(values.empty() || values.size() == x.size(), "{} values of {} disks", values.size(), x.size());
  SPH_CHECK(radius >= 0, "radius {}", radius);
  fit_.Add(values);

  const double scale = view_.Scale();
  batches_.push_back({disks_.size(), radius * scale, !values.empty()});
  const Vec2 centre = view_.region.Centre();
  const double x_limit = 0.5 * view_.width + EdgeOf(radius * scale).reach;
  const double y_limit = 0.5 * view_.height + EdgeOf(radius * scale).reach;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double x_pixel = scale * (x[i] - centre.x);
    const double y_pixel = scale * (y[i] - centre.y);
    if (!(std::abs(x_pixel) < x_limit && std::abs(y_pixel) < y_limit)) continue;  // also if it is not a number
    disks_.push_back({static_cast<float>(x_pixel), static_cast<float>(y_pixel), {}});
    values_.push_back(values.empty() ? 0 : values[i]);
  }
}

void DiskPainter::Draw(const std::optional<ColourRange>& range) {
  if (disks_.empty()) return;
  Colour(range.value_or(ColourRange{}));
  sorted_.resize(disks_.size());
  const std::span<const DiskVertex> disks = disks_;
  const std::span<DiskVertex> sorted = sorted_;
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    const std::size_t first = batches_[b].first;
    const std::size_t count = End(b) - first;
    SortByTile(disks.subspan(first, count), sorted.subspan(first, count), view_.width, view_.height);
  }
  arrays_.Bind();
  buffer_.Upload(sorted_);
  for (std::size_t b = 0; b < batches_.size(); ++b) DrawBatch(batches_[b], End(b));
}

std::size_t DiskPainter::End(std::size_t batch) const {
  return batch + 1 < batches_.size() ? batches_[batch + 1].first : disks_.size();
}

void DiskPainter::Colour(const ColourRange& range) {
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    if (!batches_[b].coloured) continue;
    for (std::size_t i = batches_[b].first; i < End(b); ++i) disks_[i].colour = ColourOf(values_[i], range);
  }
}

bool DiskPainter::PointsCanBe(double size) const {
  return size <= largest_point_ && view_.width + size <= largest_viewport_[0] &&
         view_.height + size <= largest_viewport_[1];
}

void DiskPainter::DrawBatch(const Batch& batch, std::size_t end) {
  if (batch.first == end) return;
  const Edge edge = EdgeOf(batch.radius);
  const bool as_points = PointsCanBe(2 * std::ceil(edge.reach));
  const int margin = as_points ? static_cast<int>(std::ceil(edge.reach)) : 0;
  ShaderProgram& program = as_points ? points_ : quads_;
  program.Use();
  program.Set("half_window", 0.5F * static_cast<float>(view_.width), 0.5F * static_cast<float>(view_.height));
  program.Set("half_viewport", 0.5F * static_cast<float>(view_.width) + static_cast<float>(margin),
              0.5F * static_cast<float>(view_.height) + static_cast<float>(margin));
  program.Set("reach", static_cast<float>(edge.reach));
  program.Set("ink", static_cast<float>(edge.ink));
  SetAttribute(gl_, 0, 2, GL_FLOAT, sizeof(DiskVertex), batch.first * sizeof(DiskVertex) + offsetof(DiskVertex, x));
  SetAttribute(gl_, 1, 3, GL_UNSIGNED_BYTE, sizeof(DiskVertex),
               batch.first * sizeof(DiskVertex) + offsetof(DiskVertex, colour));
  for (const GLuint location : {0U, 1U}) gl_.VertexAttribDivisor(location, as_points ? 0 : 1);

  const auto count = static_cast<GLsizei>(end - batch.first);
  gl_.Viewport(-margin, -margin, view_.width + 2 * margin, view_.height + 2 * margin);
  if (as_points) {
    gl_.Enable(GL_PROGRAM_POINT_SIZE);
    gl_.DrawArrays(GL_POINTS, 0, count);
  } else {
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
  }
  gl_.Viewport(0, 0, view_.width, view_.height);
}

}  // namespace sph
