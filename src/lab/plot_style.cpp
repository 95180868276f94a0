#include "lab/plot_style.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph {

Series Curve(std::string name, std::vector<double> x, std::vector<double> y) {
  return {.name = std::move(name), .x = std::move(x), .y = std::move(y), .marker = Marker::kAuto};
}

Series Scatter(std::string name, std::vector<double> x, std::vector<double> y) {
  const double crowd = std::max(1.0, static_cast<double>(x.size()) / 100);
  return {.name = std::move(name),
          .x = std::move(x),
          .y = std::move(y),
          .line = Line::kNone,
          .marker = Marker::kAuto,
          .opacity = std::max(0.3, std::pow(crowd, -0.25)),
          .marker_size = std::max(4.0, 12 * std::pow(crowd, -0.25))};
}

Series Theory(std::string name, std::vector<double> x, std::vector<double> y) {
  return {.name = std::move(name), .x = std::move(x), .y = std::move(y), .line = Line::kDashed, .colour = Colour{}};
}

Series Styled(const Plot& plot, std::size_t index) {
  const auto automatic_before = [&](auto chosen_for_it) {
    return static_cast<std::size_t>(
        std::count_if(plot.series.begin(), plot.series.begin() + static_cast<std::ptrdiff_t>(index), chosen_for_it));
  };
  Series series = plot.series[index];
  if (!series.colour) series.colour = kPalette[automatic_before([](auto& s) { return !s.colour; }) % kPalette.size()];
  if (series.marker == Marker::kAuto) {
    const std::size_t n = automatic_before([](auto& s) { return s.marker == Marker::kAuto; });
    series.marker = kMarkers[(n + n / kPalette.size()) % kMarkers.size()];  // another shape when the colours come again
  }
  return series;
}

Colour ColourOf(const Band& band) { return band.colour.value_or(Colour{0.4, 0.4, 0.4}); }

Colour MapColour(double part) {
  constexpr double kStart = 0.4, kRotations = -0.65, kHue = 1.2;
  const double brightness = 0.12 + 0.8 * part;  // neither black nor white, which the plot itself uses
  const double angle = 2 * std::numbers::pi * (kStart / 3 + kRotations * part);
  const double amplitude = kHue * brightness * (1 - brightness) / 2;
  const auto channel = [&](double cosine, double sine) {
    return std::clamp(brightness + amplitude * (cosine * std::cos(angle) + sine * std::sin(angle)), 0.0, 1.0);
  };
  return {channel(-0.14861, 1.78277), channel(-0.29227, -0.90649), channel(1.97294, 0)};
}

}  // namespace sph
