// Walls: lines a few pixels wide, gathered during a frame and drawn at once.
#pragma once

#include <vector>

#include "base/vec2.hpp"
#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/view.hpp"

namespace sph {

class WallPainter {
 public:
  explicit WallPainter(const GlFunctions& gl);

  /// Forgets the walls of the last frame. @param width  of a wall [pixels], >= 1
  void Begin(const View& view, double width);
  /// The segment from a to b [m]; nothing if an end is nowhere (NaN). A wall parallel to an axis is moved by up to half
  /// a pixel, so that its edges are the pixels'; the ends reach over by half the width, so that corners are filled.
  void Add(Vec2 a, Vec2 b);
  /// Blending must be on.
  void Draw();

 private:
  /// A corner of a wall's rectangle; see shaders/walls.vert.
  struct Vertex {
    float x, y;
    float along, across;
    float half_length, half_width;
  };

  const GlFunctions& gl_;
  ShaderProgram program_;
  VertexArray arrays_;
  Buffer buffer_;
  View view_;
  double width_ = 1;
  std::vector<Vertex> vertices_;  // two triangles a wall
};

}  // namespace sph
