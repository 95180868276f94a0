// Disks: gathered during a frame, then uploaded once and drawn.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/colour_range.hpp"
#include "render/disk_vertex.hpp"
#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/view.hpp"

namespace sph {

class DiskPainter {
 public:
  explicit DiskPainter(const GlFunctions& gl);

  /// Forgets the disks of the last frame.
  void Begin(const View& view);
  /// As Canvas::DrawDisks. Keeps what can be seen.
  void Add(std::span<const double> x, std::span<const double> y, double radius, std::span<const double> values);
  /// The finite range of the values added (also of disks that are not seen), if there are any.
  std::optional<ColourRange> Fitted() const { return fit_.Range(); }
  /// One upload of all disks, one draw call for each Add. Blending must be on.
  void Draw(const std::optional<ColourRange>& range);

 private:
  /// The disks of one Add: from first to the next batch's first.
  struct Batch {
    std::size_t first = 0;
    double radius = 0;      // [pixels]
    bool coloured = false;  // each has a value
  };

  void Colour(const ColourRange& range);
  void DrawBatch(const Batch& batch, std::size_t end);
  bool PointsCanBe(double size) const;
  std::size_t End(std::size_t batch) const;

  const GlFunctions& gl_;
  ShaderProgram points_;
  ShaderProgram quads_;
  VertexArray arrays_;
  Buffer buffer_;
  double largest_point_ = 0;      // [pixels]
  int largest_viewport_[2] = {};  // [pixels]
  View view_;
  std::vector<Batch> batches_;
  std::vector<DiskVertex> disks_;
  std::vector<double> values_;      // of disks_; 0 where a batch has none
  std::vector<DiskVertex> sorted_;  // disks_ in the order drawn
  RangeFit fit_;
};

}  // namespace sph
