// A disk as one point sprite: the fastest way where the driver's largest point is large enough.
#version 330 core

layout(location = 0) in vec2 centre;  // pixels from the middle of the window, y upwards
layout(location = 1) in vec3 colour;

uniform vec2 half_window;    // pixels
uniform vec2 half_viewport;  // pixels: larger than the window, since a point is dropped when its centre is outside
uniform float reach;         // pixels from the centre to where the smooth edge ends

flat out vec2 window_centre;
flat out vec3 ink_colour;

void main() {
  window_centre = centre + half_window;
  ink_colour = colour;
  gl_PointSize = 2.0 * reach;
  gl_Position = vec4(centre / half_viewport, 0.0, 1.0);
}
