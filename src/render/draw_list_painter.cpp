#include "render/draw_list_painter.hpp"

#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace sph {

DrawListPainter::DrawListPainter(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "text.vert", "text.frag"),
      arrays_(gl),
      vertices_(gl, GL_ARRAY_BUFFER),
      indices_(gl, GL_ELEMENT_ARRAY_BUFFER),
      letters_(gl) {}

void DrawListPainter::UploadFonts(ImFontAtlas& atlas) {
  unsigned char* ink = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsAlpha8(&ink, &width, &height);
  letters_.Bind();
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, ink);
  atlas.SetTexID(AsPointer(letters_.Name()));
  atlas.ClearTexData();
}

void DrawListPainter::Draw(const ImDrawData& data) {
  program_.Use();
  program_.Set("window", data.DisplaySize.x, data.DisplaySize.y);
  program_.Set("font", 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.Enable(GL_SCISSOR_TEST);
  arrays_.Bind();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList* list = data.CmdLists[i];  // a pointer to them or, from Dear ImGui 1.89.8 on, a vector
    vertices_.Upload(std::span(list->VtxBuffer.Data, static_cast<std::size_t>(list->VtxBuffer.Size)));
    indices_.Upload(std::span(list->IdxBuffer.Data, static_cast<std::size_t>(list->IdxBuffer.Size)));
    SetAttribute(gl_, 0, 2, GL_FLOAT, sizeof(ImDrawVert), offsetof(ImDrawVert, pos));
    SetAttribute(gl_, 1, 2, GL_FLOAT, sizeof(ImDrawVert), offsetof(ImDrawVert, uv));
    SetAttribute(gl_, 2, 4, GL_UNSIGNED_BYTE, sizeof(ImDrawVert), offsetof(ImDrawVert, col));
    for (const ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback == nullptr) DrawCommand(command, static_cast<int>(data.DisplaySize.y));
    }
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

void DrawListPainter::DrawCommand(const ImDrawCmd& command, int height) {
  const ImVec4& clip = command.ClipRect;  // left, top, right, bottom
  if (clip.z <= clip.x || clip.w <= clip.y) return;
  gl_.Scissor(static_cast<GLint>(clip.x), height - static_cast<GLint>(clip.w), static_cast<GLsizei>(clip.z - clip.x),
              static_cast<GLsizei>(clip.w - clip.y));
  gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
  const GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type,
                             AsPointer(command.IdxOffset * sizeof(ImDrawIdx)), static_cast<GLint>(command.VtxOffset));
}

}  // namespace sph
