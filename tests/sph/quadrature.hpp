// Integrals by Gauss's rule on panels: how the tests get at a kernel's constant without its formula.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace sph {

/// Integral of f over [a, b]: five Gauss points on each of `panels` panels, exact for polynomials up to degree 9.
template <typename F>
double Integral(F f, double a, double b, int panels = 1) {
  const double s = 2 * std::sqrt(10.0 / 7);
  const std::array<double, 3> point = {0, std::sqrt(5 - s) / 3, std::sqrt(5 + s) / 3};
  const double root = 13 * std::sqrt(70.0);
  const std::array<double, 3> weight = {128.0 / 225, (322 + root) / 900, (322 - root) / 900};
  double sum = 0;
  for (int k = 0; k < panels; ++k) {
    const double half = 0.5 * (b - a) / panels;
    const double middle = a + (2 * k + 1) * half;
    sum += half * weight[0] * f(middle);
    for (int n : {1, 2}) sum += half * weight[n] * (f(middle - half * point[n]) + f(middle + half * point[n]));
  }
  return sum;
}

/// Integral of a function of the distance r over the line (dimension 1), the plane (2) or space (3), out to `radius`:
/// panels end at the half and the whole of `radius`, where kernels have their knots, and shrink towards r = 0 for the
/// sake of logarithms.
template <typename F>
double IntegralOverAll(F f, int dimension, double radius) {
  using std::numbers::pi;
  const auto shell = [&](double r) {
    return f(r) * (dimension == 1 ? 2 : dimension == 2 ? 2 * pi * r : 4 * pi * r * r);
  };
  double sum = 0;
  for (double outer = radius; outer > 1e-12 * radius; outer /= 2) sum += Integral(shell, outer / 2, outer, 4);
  return sum;
}

}  // namespace sph
