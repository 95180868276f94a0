#include "commands/montage.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "lab/plot_style.hpp"
#include "lab/plot_surface.hpp"

namespace sph {
namespace {

// [pixels]
constexpr int kCaptionHeight = 36;
constexpr double kCaptionSize = 20;
constexpr double kCaptionLeft = 10;

constexpr std::uint8_t kGapGrey = 190;

Image Plain(int width, int height, std::uint8_t grey) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint8_t>(3 * pixels, grey)};
}

void Paste(Image& image, int x, int y, const Image& part) {
  for (int row = 0; row < part.height; ++row) {
    const auto first = image.Pixel(x, y + row) - image.rgb.data();
    std::copy_n(part.Pixel(0, row), 3 * part.width, image.rgb.begin() + first);
  }
}

}  // namespace

Image WithCaption(const Image& picture, const std::string& caption) {
  Surface line(picture.width, kCaptionHeight);
  line.SetColour(kInk);
  const double size = FittingSize(caption, kCaptionSize, std::max(1.0, picture.width - 2 * kCaptionLeft));
  DrawText(line, caption, {kCaptionLeft, 0.5 * kCaptionHeight}, size, Anchor::kLeft);

  Image image = line.ToImage();
  image.height += picture.height;
  image.rgb.insert(image.rgb.end(), picture.rgb.begin(), picture.rgb.end());
  return image;
}

Image JoinPanels(std::span<const Image> panels, int columns, int gap) {
  SPH_CHECK(!panels.empty() && columns >= 1 && gap >= 0, "{} panels, {} columns, gap {}", panels.size(), columns, gap);
  const int count = static_cast<int>(panels.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  const int width = panels[0].width, height = panels[0].height;

  Image image = Plain(columns * (width + gap) - gap, rows * (height + gap) - gap, kGapGrey);
  for (int i = 0; i < columns * rows; ++i) {
    const int x = i % columns * (width + gap), y = i / columns * (height + gap);
    if (i >= count) {
      Paste(image, x, y, Plain(width, height, 255));
      continue;
    }
    const Image& panel = panels[static_cast<std::size_t>(i)];
    SPH_CHECK(panel.width == width && panel.height == height, "panel {} has {} x {} pixels, the first {} x {}", i,
              panel.width, panel.height, width, height);
    Paste(image, x, y, panel);
  }
  return image;
}

}  // namespace sph
