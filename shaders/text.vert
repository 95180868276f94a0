// Letters and panels: the triangles of Dear ImGui's draw lists.
#version 330 core

layout(location = 0) in vec2 position;  // pixels from the top left corner of the window
layout(location = 1) in vec2 texture_position;
layout(location = 2) in vec4 colour;

uniform vec2 window;  // pixels

out vec2 glyph;
out vec4 tint;

void main() {
  glyph = texture_position;
  tint = colour;
  gl_Position = vec4(2.0 * position.x / window.x - 1.0, 1.0 - 2.0 * position.y / window.y, 0.0, 1.0);
}
