#include "window/ui_scale.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "render/text.hpp"

namespace sph {
namespace {

constexpr double kSmallest = 0.5;
constexpr double kLargest = 8;

std::optional<double> Asked() {
  const char* variable = std::getenv("SPHLAB_UI_SCALE");
  if (variable == nullptr || *variable == '\0') return std::nullopt;
  const std::string_view text = variable;
  double scale = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
  if (error == std::errc() && end == text.data() + text.size() && scale >= kSmallest && scale <= kLargest) return scale;
  throw UsageError("SPHLAB_UI_SCALE={}: it takes a number from {} to {}; 1 is text of 15 pixels", text, kSmallest,
                   kLargest);
}

}  // namespace

UiScale::UiScale(std::optional<double> dots_per_inch) : asked_(Asked()) {
  constexpr double kUsual = 96;  // [dots per inch]
  if (dots_per_inch) desktop_ = std::clamp(*dots_per_inch / kUsual, kSmallest, kLargest);
}

double UiScale::For(int width, int height) const {
  if (asked_) return *asked_;
  const double scale = std::max(desktop_, UiScaleFor(width, height));
  return std::clamp(std::round(4 * scale) / 4, kSmallest, kLargest);
}

}  // namespace sph
