// The letters: DejaVu Sans in the few sizes that text is set in.
#pragma once

#include <array>

struct ImFont;
struct ImFontAtlas;

namespace sph {

/// From the usual size to the smallest, which text takes that would not fit otherwise.
using Fonts = std::array<ImFont*, 3>;

/// Clears `atlas` and puts the fonts in it, 15, 12 and 10 pixels high times `ui_scale`, with the letters, signs and
/// arrows that physics needs. The font file is embedded in the program.
Fonts AddFonts(ImFontAtlas& atlas, double ui_scale);

}  // namespace sph
