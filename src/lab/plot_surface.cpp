#include "lab/plot_surface.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "base/check.hpp"
#include "base/error.hpp"

namespace sph {
namespace {

constexpr double kCapitalHeight = 0.73;  // of DejaVu Sans, as a part of the size

void SetFont(cairo_t* context, double size) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
  // The same letters whatever the machine's font settings are.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

/// Words; what is like "t = 0.5 s" counts as one.
std::vector<std::string> WordsOf(const std::string& text) {
  constexpr std::size_t kLongestUnit = 3;
  std::vector<std::string> words;
  std::istringstream parts(text);
  std::string before;
  for (std::string part; parts >> part; before = part) {
    const bool unit =
        !before.empty() && part.size() <= kLongestUnit && std::isdigit(static_cast<unsigned char>(before.back()));
    if (!words.empty() && (part == "=" || before == "=" || unit)) {
      words.back() += " " + part;
    } else {
      words.push_back(part);
    }
  }
  return words;
}

}  // namespace

Surface::Surface(int width, int height) : width_(width), height_(height) {
  SPH_CHECK(1 <= width && width <= 16000 && 1 <= height && height <= 16000, "size {} x {}", width, height);
  surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  context_.reset(cairo_create(surface_.get()));
  const cairo_status_t status = cairo_status(context_.get());
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw TroubleError("a plot of {} x {} pixels: {}", width, height, cairo_status_to_string(status));
}

void Surface::SetColour(Colour colour, double opacity) {
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, opacity);
}

void Surface::FillBox(const Box& box) {
  cairo_rectangle(context_.get(), box.x0, box.y0, box.Width(), box.Height());
  cairo_fill(context_.get());
}

void Surface::Hairline(Vec2 a, Vec2 b, double width) {
  const double whole = std::max(1.0, std::round(width));
  const bool vertical = a.x == b.x;
  const double corner = std::round((vertical ? a.x : a.y) - whole / 2);
  if (vertical) {
    FillBox({corner, std::round(std::min(a.y, b.y)), corner + whole, std::round(std::max(a.y, b.y))});
  } else {
    FillBox({std::round(std::min(a.x, b.x)), corner, std::round(std::max(a.x, b.x)), corner + whole});
  }
}

void Surface::Paint(Surface& other) {
  cairo_set_source_surface(context_.get(), other.surface_.get(), 0, 0);
  cairo_paint(context_.get());
}

double Surface::Ink(const Box& box) {
  cairo_surface_flush(surface_.get());
  const unsigned char* bytes = cairo_image_surface_get_data(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get());
  const int x0 = std::max(0, static_cast<int>(box.x0)), x1 = std::min(width_, static_cast<int>(std::ceil(box.x1)));
  const int y0 = std::max(0, static_cast<int>(box.y0)), y1 = std::min(height_, static_cast<int>(std::ceil(box.y1)));
  if (x0 >= x1 || y0 >= y1) return 0;
  double sum = 0;
  for (int y = y0; y < y1; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = x0; x < x1; ++x) sum += row[x] >> 24;
  }
  return sum / (255.0 * (x1 - x0) * (y1 - y0));
}

Image Surface::ToImage() {
  cairo_surface_flush(surface_.get());
  const unsigned char* bytes = cairo_image_surface_get_data(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get());
  Image image{width_, height_, {}};
  image.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < width_; ++x) {
      const std::uint32_t white = 255 - (row[x] >> 24);  // colours are stored multiplied by their opacity
      for (const int shift : {16, 8, 0}) {
        image.rgb.push_back(static_cast<std::uint8_t>(((row[x] >> shift) & 0xff) + white));
      }
    }
  }
  return image;
}

void DrawText(Surface& surface, const std::string& text, Vec2 at, double size, Anchor anchor, bool upwards) {
  cairo_t* context = surface.Context();
  cairo_save(context);
  SetFont(context, size);
  cairo_translate(context, at.x, at.y);
  if (upwards) cairo_rotate(context, -std::acos(0.0));
  const double part = anchor == Anchor::kLeft ? 0 : anchor == Anchor::kMiddle ? 0.5 : 1;
  cairo_move_to(context, -part * WidthOfText(text, size), 0.5 * kCapitalHeight * size);
  cairo_show_text(context, text.c_str());
  cairo_restore(context);
}

double WidthOfText(const std::string& text, double size) {
  Surface paper(1, 1);
  SetFont(paper.Context(), size);
  cairo_text_extents_t extents;
  cairo_text_extents(paper.Context(), text.c_str(), &extents);
  return extents.x_advance;
}

double FittingSize(const std::string& text, double size, double width) {
  const double needed = WidthOfText(text, size);
  return needed > width ? size * width / needed : size;
}

std::vector<std::string> Wrap(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  for (const std::string& word : WordsOf(text)) {
    if (!lines.empty() && WidthOfText(lines.back() + " " + word, size) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace sph
