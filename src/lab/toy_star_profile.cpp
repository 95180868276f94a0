#include "lab/toy_star_profile.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/plot_axes.hpp"
#include "lab/plot_style.hpp"

namespace sph {
namespace {

constexpr int kCurvePoints = 200;

Series ExactProfile(const ToyStar& star) {
  Series exact{.name = "exact: λ/(4k) (R² − r²)", .colour = kPalette[1], .line_width = 2};
  for (int i = 0; i <= kCurvePoints; ++i) {
    exact.x.push_back(star.radius * i / kCurvePoints);
    exact.y.push_back(star.Density(exact.x.back()));
  }
  return exact;
}

/// "2.3×10⁻³"
std::string Scientific(double value) {
  if (!(value > 0) || !std::isfinite(value)) return fmt::format("{:g}", value);
  const int exponent = static_cast<int>(std::floor(std::log10(value)));
  return fmt::format("{:.1f}×{}", value / std::pow(10.0, exponent), PowerOfTen(exponent));
}

}  // namespace

Plot ToyStarProfile(const ParticleSystem& system, const ToyStar& star) {
  const Particles& state = system.State();
  const std::vector<double> density = system.Density();
  std::vector<double> r(state.Size());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = Length(state.Position(i));
  const DensityErrors errors = CompareDensity(star, state.x, state.y, density);

  Plot plot;
  plot.title =
      fmt::format("Toy star of {} particles at t = {:g} s", state.Size(), std::round(100 * system.Time()) / 100);
  plot.x.label = "distance from the centre r [m]";
  plot.x.low = 0;
  plot.y.label = "density ρ [kg/m³]";
  plot.y.low = 0;
  plot.series.push_back(
      Scatter(fmt::format("particles, mean square error {} kg²/m⁶", Scientific(errors.mse)), r, density));
  plot.series.back().colour = kPalette[0];
  plot.series.push_back(ExactProfile(star));
  return plot;
}

}  // namespace sph
