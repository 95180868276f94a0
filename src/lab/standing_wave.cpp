#include "lab/standing_wave.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace sph {

std::complex<double> StandingWave::Root() const {
  using Complex = std::complex<double>;
  const double t = std::tanh(k * depth);
  const double inviscid = std::sqrt(gravity * k * t);
  const auto residual = [&](Complex s) {
    const Complex m = std::sqrt(k * k + s / viscosity);
    const Complex sum = m * m + k * k;
    return sum * sum + gravity * k * t / (viscosity * viscosity) - 4 * k * k * k * m * t / std::tanh(m * depth);
  };
  Complex s{-2 * viscosity * k * k, inviscid};
  constexpr int kMostSteps = 50;
  for (int step = 0; step < kMostSteps; ++step) {  // of Newton's method
    const Complex delta = 1e-6 * inviscid;
    const Complex slope = (residual(s + delta) - residual(s - delta)) / (2.0 * delta);
    const Complex correction = residual(s) / slope;
    s -= correction;
    if (std::abs(correction) < 1e-13 * inviscid) break;
  }
  return s;
}

Vec2 StandingWave::Shape(double x, double y) const {
  const double top = std::sinh(k * depth);
  return {std::sin(k * x) * std::cosh(k * y) / top, -std::cos(k * x) * std::sinh(k * y) / top};
}

std::complex<double> FitDecay(const PointSeries& samples) {
  std::vector<double> zeros, areas;
  double area = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Vec2 a = samples[i - 1], b = samples[i];
    if ((a.y > 0) == (b.y > 0)) {
      area += 0.5 * (a.y + b.y) * (b.x - a.x);
      continue;
    }
    const double zero = a.x + (b.x - a.x) * a.y / (a.y - b.y);
    if (!zeros.empty()) areas.push_back(std::abs(area + 0.5 * a.y * (zero - a.x)));
    zeros.push_back(zero);
    area = 0.5 * b.y * (b.x - zero);
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (zeros.size() < 4) return {kNone, kNone};
  const auto swings = static_cast<double>(areas.size());
  const double frequency = std::numbers::pi * swings / (zeros.back() - zeros.front());
  // The slope of log(area) against the number of the swing, by least squares.
  double slope = 0, squares = 0;
  for (std::size_t n = 0; n < areas.size(); ++n) {
    const double from_middle = static_cast<double>(n) - 0.5 * (swings - 1);
    slope += from_middle * std::log(areas[n]);
    squares += from_middle * from_middle;
  }
  return {slope / squares * frequency / std::numbers::pi, frequency};
}

}  // namespace sph
