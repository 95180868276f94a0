// A disk as an instance of a square of two triangles: of any size.
#version 330 core

layout(location = 0) in vec2 centre;  // pixels from the middle of the window, y upwards
layout(location = 1) in vec3 colour;

uniform vec2 half_window;    // pixels
uniform vec2 half_viewport;  // pixels
uniform float reach;         // pixels from the centre to where the smooth edge ends

flat out vec2 window_centre;
flat out vec3 ink_colour;

void main() {
  window_centre = centre + half_window;
  ink_colour = colour;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  gl_Position = vec4((centre + reach * corner) / half_viewport, 0.0, 1.0);
}
