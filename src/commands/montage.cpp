#include "commands/montage.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "lab/plot_style.hpp"
#include "lab/plot_surface.hpp"

namespace sph {
namespace {

// [pixels]
constexpr int kGap = 2;
constexpr int kCaptionHeight = 36;
constexpr double kCaptionSize = 20;
constexpr double kCaptionLeft = 10;

constexpr std::uint8_t kGapGrey = 190;

Image CaptionOf(const std::string& text, int width) {
  Surface surface(width, kCaptionHeight);
  surface.SetColour(kInk);
  const double size = FittingSize(text, kCaptionSize, width - 2 * kCaptionLeft);
  DrawText(surface, text, {kCaptionLeft, 0.5 * kCaptionHeight}, size, Anchor::kLeft);
  return surface.ToImage();
}

void Paste(Image& image, int x, int y, const Image& part) {
  for (int row = 0; row < part.height; ++row) {
    const auto first = image.Pixel(x, y + row) - image.rgb.data();
    std::copy_n(part.Pixel(0, row), 3 * part.width, image.rgb.begin() + first);
  }
}

Image Plain(int width, int height, std::uint8_t grey) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint8_t>(3 * pixels, grey)};
}

}  // namespace

Image JoinPanels(std::span<const Panel> panels, int columns) {
  SPH_CHECK(!panels.empty() && columns >= 1, "{} panels, {} columns", panels.size(), columns);
  const int count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  const int width = panels[0].picture.width, height = panels[0].picture.height + kCaptionHeight;
  Image image = Plain(columns * (width + kGap) - kGap, rows * (height + kGap) - kGap, kGapGrey);
  for (int i = 0; i < columns * rows; ++i) {
    const int x = i % columns * (width + kGap), y = i / columns * (height + kGap);
    if (i >= count) {
      Paste(image, x, y, Plain(width, height, 255));
      continue;
    }
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    SPH_CHECK(panel.picture.width == width && panel.picture.height + kCaptionHeight == height,
              "panel {} has {} x {} pixels", i, panel.picture.width, panel.picture.height);
    Paste(image, x, y, CaptionOf(panel.caption, width));
    Paste(image, x, y + kCaptionHeight, panel.picture);
  }
  return image;
}

}  // namespace sph
