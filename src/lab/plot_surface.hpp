// A picture being drawn with Cairo: what plots need of it, and no more.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "lab/plot.hpp"

namespace sph {

/// Coordinates are pixels from the top left corner, y downwards; the first pixel is from 0 to 1.
class Surface {
 public:
  /// Transparent. Precondition: 1 <= width, height <= 16000. TroubleError if there is no memory for it.
  Surface(int width, int height);

  cairo_t* Context() { return context_.get(); }
  int Width() const { return width_; }
  int Height() const { return height_; }

  void SetColour(Colour colour, double opacity = 1);
  void FillBox(const Box& box);
  /// A line `width` whole pixels wide with sharp edges, horizontal or vertical.
  void Hairline(Vec2 a, Vec2 b, double width);
  /// Lays the other picture of the same size over this one.
  void Paint(Surface& other);

  /// Mean opacity in the part of the box that is in the picture, 0 ... 1.
  double Ink(const Box& box);
  /// The picture on white.
  Image ToImage();

 private:
  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  int width_ = 0;
  int height_ = 0;
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> context_;
};

/// Which point of a line of text stands where it is put.
enum class Anchor { kLeft, kMiddle, kRight };

/// One line, its `anchor` at x and the middle of its capital letters at y; `upwards`: turned a quarter to the left.
void DrawText(Surface& surface, const std::string& text, Vec2 at, double size, Anchor anchor, bool upwards = false);

/// [pixels]
double WidthOfText(const std::string& text, double size);
/// From one line to the next.
constexpr double LineHeight(double size) { return 1.3 * size; }

/// The size, `size` or less, at which the text is at most `width` wide.
double FittingSize(const std::string& text, double size, double width);
/// The text in lines of at most `width`, broken between words, but not within "t = 0.5 s"; what is longer has a line of
/// its own.
std::vector<std::string> Wrap(const std::string& text, double size, double width);

}  // namespace sph
