#include "render/legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace sph {
namespace {

/// `value` to the decimal place that tells `step` apart; with a power of ten where plain digits would be many.
std::string Label(double value, double step, double greatest) {
  if (greatest >= 1e7 || step < 1e-6) {
    const double digits = std::ceil(std::log10(greatest / step));
    return fmt::format("{:.{}e}", value, static_cast<int>(std::clamp(digits, 1.0, 16.0)));
  }
  const double decimals = std::max(0.0, -std::floor(std::log10(step)));
  const std::string label = fmt::format("{:.{}f}", value, static_cast<int>(decimals));
  return label.find_first_not_of("-0.") == std::string::npos ? "0" : label;
}

}  // namespace

std::string QuantityTitle(Colouring colouring) {
  switch (colouring) {
    case Colouring::kSpeed:
      return "speed [m/s]";
    case Colouring::kPressure:
      return "pressure [Pa]";
    case Colouring::kDensity:
      return "density [kg/m³]";
    case Colouring::kBlackDisks:
      break;
  }
  SPH_CHECK(false, "colouring {} shows no quantity", static_cast<int>(colouring));
}

LegendText LegendOf(Colouring colouring, const ColourRange& range) {
  const double greatest = std::max(std::abs(range.low), std::abs(range.high));
  const double step = 0.01 * (range.high - range.low);
  return {QuantityTitle(colouring), Label(range.low, step, greatest), Label(range.high, step, greatest)};
}

}  // namespace sph
