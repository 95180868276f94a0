// The ink of a disk in a pixel: full inside, none outside, falling over the pixel's width where the edge passes.
#version 330 core

flat in vec2 window_centre;
flat in vec3 ink_colour;

uniform float reach;  // pixels from the centre to where the smooth edge ends
uniform float ink;    // below 1 for disks smaller than a pixel

out vec4 pixel;

void main() {
  pixel = vec4(ink_colour, ink * clamp(reach - distance(gl_FragCoord.xy, window_centre), 0.0, 1.0));
}
