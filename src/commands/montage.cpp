#include "commands/montage.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace sph {
namespace {

constexpr std::uint8_t kGapGrey = 190;

void Fill(Image& image, int x, int y, int width, int height, std::uint8_t grey) {
  for (int row = y; row < y + height; ++row) {
    std::uint8_t* first = image.rgb.data() + (image.Pixel(x, row) - image.rgb.data());
    std::fill_n(first, 3 * width, grey);
  }
}

void Paste(Image& image, int x, int y, const Image& panel) {
  for (int row = 0; row < panel.height; ++row) {
    std::copy_n(panel.Pixel(0, row), 3 * panel.width, image.rgb.data() + (image.Pixel(x, y + row) - image.rgb.data()));
  }
}

}  // namespace

Image JoinPanels(std::span<const Image> panels, int columns, int gap) {
  SPH_CHECK(!panels.empty() && columns >= 1 && gap >= 0, "{} panels, {} columns, gap {}", panels.size(), columns, gap);
  const int count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  const int width = panels[0].width, height = panels[0].height;
  columns = std::min(columns, count);

  Image image{columns * (width + gap) - gap, rows * (height + gap) - gap, {}};
  image.rgb.assign(std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                   kGapGrey);
  for (int i = 0; i < columns * rows; ++i) {
    const int x = i % columns * (width + gap), y = i / columns * (height + gap);
    if (i >= count) {
      Fill(image, x, y, width, height, 255);
      continue;
    }
    const Image& panel = panels[static_cast<std::size_t>(i)];
    SPH_CHECK(panel.width == width && panel.height == height, "panel {}: {} x {}, not {} x {}", i, panel.width,
              panel.height, width, height);
    Paste(image, x, y, panel);
  }
  return image;
}

}  // namespace sph
