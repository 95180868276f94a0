// The ink of a wall in a pixel: the overlap of the wall with the pixel, exact where the wall is parallel to an axis.
#version 330 core

in vec2 offset;
flat in vec2 edge;

out vec4 pixel;

void main() {
  vec2 overlap = clamp(edge + 0.5 - abs(offset), 0.0, 1.0);
  pixel = vec4(vec3(0.25), overlap.x * overlap.y);
}
