// Draws what Dear ImGui has laid out, text and panels, with our shaders and our table of OpenGL functions.
#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"

struct ImDrawCmd;
struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace sph {

class DrawListPainter {
 public:
  explicit DrawListPainter(const GlFunctions& gl);

  /// Builds the picture of all letters and uploads it; the atlas then knows it by our texture's name.
  void UploadFonts(ImFontAtlas& atlas);
  /// Draws into a window of the size that `data` says. Blending must be on.
  void Draw(const ImDrawData& data);

 private:
  void DrawCommand(const ImDrawCmd& command, int height);

  const GlFunctions& gl_;
  ShaderProgram program_;
  VertexArray arrays_;
  Buffer vertices_;
  Buffer indices_;
  Texture letters_;
};

}  // namespace sph
