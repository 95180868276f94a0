// Letters and panels: the font's picture holds how much ink each point has, and is white.
#version 330 core

in vec2 glyph;
in vec4 tint;

uniform sampler2D font;

out vec4 pixel;

void main() { pixel = vec4(tint.rgb, tint.a * texture(font, glyph).r); }
