#include "render/fonts.hpp"

#include <imgui.h>

#include <cmath>
#include <string_view>

#include "base/check.hpp"
#include "render/embedded.hpp"

namespace sph {
namespace {

constexpr std::array kSizes = {15.0, 12.0, 10.0};  // [pixels] at scale 1

// First and last of each range of characters, ended by 0.
constexpr ImWchar kCharacters[] = {
    0x0020, 0x00ff,  // Latin letters, ASCII and western European
    0x0370, 0x03ff,  // Greek letters
    0x2010, 0x2044,  // dashes, quotation marks, bullets
    0x2070, 0x209f,  // superscripts and subscripts
    0x2190, 0x2199,  // arrows
    0x2200, 0x2265,  // mathematical operators
    0,
};

}  // namespace

Fonts AddFonts(ImFontAtlas& atlas, double ui_scale) {
  SPH_CHECK(ui_scale > 0, "ui_scale {}", ui_scale);
  const std::string_view file = EmbeddedFile("DejaVuSans.ttf");
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  atlas.Clear();
  Fonts fonts = {};
  for (std::size_t i = 0; i < fonts.size(); ++i) {
    // Dear ImGui takes the file as a void*, but only reads it.
    void* bytes = const_cast<char*>(file.data());
    const auto size = static_cast<float>(std::round(kSizes[i] * ui_scale));
    fonts[i] = atlas.AddFontFromMemoryTTF(bytes, static_cast<int>(file.size()), size, &config, kCharacters);
  }
  return fonts;
}

}  // namespace sph
