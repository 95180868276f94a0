// A wall as a rectangle of two triangles, a little larger than its ink.
#version 330 core

layout(location = 0) in vec2 corner;     // pixels from the middle of the window, y upwards
layout(location = 1) in vec2 from_axes;  // pixels along and across the wall, from its middle
layout(location = 2) in vec2 half_size;  // pixels: half the wall's length and width

uniform vec2 half_window;  // pixels

out vec2 offset;
flat out vec2 edge;

void main() {
  offset = from_axes;
  edge = half_size;
  gl_Position = vec4(corner / half_window, 0.0, 1.0);
}
