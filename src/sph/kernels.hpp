// Smoothing kernels W(r, h): value, gradient and, where a term needs it, Laplacian.
#pragma once

#include <cmath>
#include <numbers>

#include "base/check.hpp"

namespace sph {

/// Cubic spline [Braune & Lewiner eq. 5]: W = C ((2-q)^3 - 4 (1-q)^3) for q < 1, C (2-q)^3 for q < 2, q = r/h.
/// C = 1/(6h) on the line, 5/(14 pi h^2) in the plane, 1/(4 pi h^3) in space, so that the integral is 1. (For the plane
/// the paper prints 15/(14 pi h^2): its integral is 3.)
template <int kDimension = 2>
class CubicSpline {
 public:
  static constexpr double kSupport = 2;  ///< support radius over h

  /// @param h  smoothing length [m], > 0.
  explicit CubicSpline(double h) : per_h_(1 / h), c_(Normalisation(h)), g_(c_ / (h * h)) {
    SPH_CHECK(h > 0, "h = {}", h);
  }

  /// W [1/m^d] at distance r >= 0 [m].
  double Value(double r) const {
    const double q = r * per_h_;
    const double outer = q < 2 ? 2 - q : 0;
    const double inner = q < 1 ? 1 - q : 0;
    return c_ * (outer * outer * outer - 4 * (inner * inner * inner));
  }
  /// g [1/m^(d+2)] with grad_i W = g (x_i - x_j), i.e. W'(r)/r. Never positive; -12 C/h^2 at r = 0.
  double Gradient(double r) const {
    const double q = r * per_h_;
    const double outer = q < 2 ? 2 - q : 0;
    return g_ * (q < 1 ? 9 * q - 12 : -3 * outer * outer / q);
  }

 private:
  static double Normalisation(double h) {
    static_assert(kDimension >= 1 && kDimension <= 3);
    if constexpr (kDimension == 1) return 1 / (6 * h);
    if constexpr (kDimension == 2) return 5 / (14 * std::numbers::pi * h * h);
    return 1 / (4 * std::numbers::pi * h * h * h);
  }

  double per_h_;
  double c_;
  double g_;
};

/// Wendland C2 in the plane [Dehnen & Aly, MNRAS 425 (2012) 1068, Table 1]: W = 7/(4 pi h^2) (1-q/2)^4 (1+2q) for q
/// < 2.
class WendlandC2 {
 public:
  static constexpr double kSupport = 2;

  explicit WendlandC2(double h) : per_h_(1 / h), c_(7 / (4 * std::numbers::pi * h * h)) {
    SPH_CHECK(h > 0, "h = {}", h);
  }

  /// W [1/m^2] at distance r >= 0 [m].
  double Value(double r) const {
    const double q = r * per_h_;
    const double rest = q < 2 ? 1 - 0.5 * q : 0;
    return c_ * rest * rest * rest * rest * (1 + 2 * q);
  }
  /// W'(r)/r [1/m^4].
  double Gradient(double r) const {
    const double q = r * per_h_;
    const double rest = q < 2 ? 1 - 0.5 * q : 0;
    return -5 * c_ * per_h_ * per_h_ * rest * rest * rest;
  }

 private:
  double per_h_;
  double c_;
};

/// Wendland C4 in the plane [ibid.]: W = 9/(4 pi h^2) (1-q/2)^6 (35/12 q^2 + 3q + 1) for q < 2.
class WendlandC4 {
 public:
  static constexpr double kSupport = 2;

  explicit WendlandC4(double h) : per_h_(1 / h), c_(9 / (4 * std::numbers::pi * h * h)) {
    SPH_CHECK(h > 0, "h = {}", h);
  }

  double Value(double r) const {
    const double q = r * per_h_;
    const double rest = q < 2 ? 1 - 0.5 * q : 0;
    return c_ * std::pow(rest, 6) * (35.0 / 12 * q * q + 3 * q + 1);
  }
  double Gradient(double r) const {
    const double q = r * per_h_;
    const double rest = q < 2 ? 1 - 0.5 * q : 0;
    return -14.0 / 3 * c_ * per_h_ * per_h_ * std::pow(rest, 5) * (1 + 2.5 * q);
  }

 private:
  double per_h_;
  double c_;
};

/// Quintic spline in the plane [Morris, Fox & Zhu, J. Comput. Phys. 136 (1997) 214, eq. 20]: W = 7/(478 pi h^2)
/// ((3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5) for q < 3, each power only where its base is positive.
class QuinticSpline {
 public:
  static constexpr double kSupport = 3;

  explicit QuinticSpline(double h) : per_h_(1 / h), c_(7 / (478 * std::numbers::pi * h * h)) {
    SPH_CHECK(h > 0, "h = {}", h);
  }

  double Value(double r) const {
    const double q = r * per_h_;
    const auto power = [q](double end) { return q < end ? std::pow(end - q, 5) : 0; };
    return c_ * (power(3) - 6 * power(2) + 15 * power(1));
  }
  double Gradient(double r) const {
    const double q = r * per_h_;
    const double c = 5 * c_ * per_h_ * per_h_;
    if (q < 1) return -c * (24 - 24 * q * q + 10 * q * q * q);  // the powers multiplied out, over q
    const auto power = [q](double end) { return q < end ? std::pow(end - q, 4) : 0; };
    return -c * (power(3) - 6 * power(2)) / q;
  }

 private:
  double per_h_;
  double c_;
};

/// Septic spline in the plane, the radial form of I. J. Schoenberg's B-spline M_8 [D. J. Price, J. Comput. Phys. 231
/// (2012) 759, section 2.6]: W = C ((4-q)^7 - 8 (3-q)^7 + 28 (2-q)^7 - 56 (1-q)^7) for q < 4, each power only where its
/// base is positive. With h as long as the spacing its knots are where a lattice's rows are: sums over square and
/// hexagonal lattices are those over the plane to four digits.
class SepticSpline {
 public:
  static constexpr double kSupport = 4;
  static constexpr double kNormalisation = 9 / (29740 * std::numbers::pi);  ///< C h^2
  /// W'/r (kFlat - kFall s^2), s = r/(4h), has the second moment of W'/r and no fourth one: with it a Laplacian is of
  /// fourth order.
  static constexpr double kFlat = 3.35422826150985;
  static constexpr double kFall = 14.491633944494291;

  explicit SepticSpline(double h) : per_h_(1 / h), c_(kNormalisation / (h * h)) { SPH_CHECK(h > 0, "h = {}", h); }

  double Value(double r) const { return c_ * Sum(r * per_h_, 7); }
  /// W'(r)/r [1/m^4] of r > 0; it has no value at 0.
  double Gradient(double r) const { return -7 * c_ * per_h_ * Sum(r * per_h_, 6) / r; }

 private:
  static double Sum(double q, int exponent) {
    const auto power = [&](double end) { return q < end ? std::pow(end - q, exponent) : 0; };
    return power(4) - 8 * power(3) + 28 * power(2) - 56 * power(1);
  }

  double per_h_;
  double c_;
};

/// Poly6 in the plane [Mueller, Charypar & Gross 2003, eq. 20, with the plane's constant]: W = 4/(pi h^8) (h^2 - r^2)^3
/// for r < h. Here h is the support radius.
class Poly6 {
 public:
  static constexpr double kSupport = 1;

  explicit Poly6(double h) : h2_(h * h), c_(4 / (std::numbers::pi * h2_ * h2_ * h2_ * h2_)) {
    SPH_CHECK(h > 0, "h = {}", h);
  }

  /// W [1/m^2] at distance r >= 0 [m].
  double Value(double r) const {
    const double rest = r * r < h2_ ? h2_ - r * r : 0;
    return c_ * (rest * rest * rest);
  }

 private:
  double h2_;
  double c_;
};

/// Spiky kernel in the plane [Mueller et al. 2003, eq. 21, with the plane's constant]: W = 10/(pi h^5) (h - r)^3 for r
/// < h.
class Spiky {
 public:
  static constexpr double kSupport = 1;

  explicit Spiky(double h) : h_(h), c_(10 / (std::numbers::pi * h * h * h * h * h)) { SPH_CHECK(h > 0, "h = {}", h); }

  double Value(double r) const {
    const double rest = r < h_ ? h_ - r : 0;
    return c_ * (rest * rest * rest);
  }
  /// W'(r) [1/m^3] = -30/(pi h^5) (h - r)^2. It does not vanish at r = 0, where its direction is undefined.
  double Slope(double r) const {
    const double rest = r < h_ ? h_ - r : 0;
    return -3 * c_ * (rest * rest);
  }

 private:
  double h_;
  double c_;
};

/// The kernel whose Laplacian is a cone, for viscosity [Mueller et al. 2003, eq. 22, with the plane's form]. In the
/// plane W'' + W'/r = 40/(pi h^5) (h - r) for r < h, with W(h) = W'(h) = 0 and unit integral, gives W = 40/(pi h^5) (h
/// r^2/4 - r^3/9 - h^3/6 ln(r/h) - 5 h^3/36): singular at r = 0, used through its Laplacian alone.
class ViscosityKernel {
 public:
  static constexpr double kSupport = 1;

  explicit ViscosityKernel(double h) : h_(h), c_(40 / (std::numbers::pi * h * h * h * h * h)) {
    SPH_CHECK(h > 0, "h = {}", h);
  }

  /// W [1/m^2] at distance r > 0 [m].
  double Value(double r) const {
    if (r >= h_) return 0;
    return c_ * (h_ * r * r / 4 - r * r * r / 9 - h_ * h_ * h_ * (std::log(r / h_) / 6 + 5.0 / 36));
  }
  /// [1/m^4] at distance r >= 0 [m]: W'' + W'/r, the Laplacian in the plane.
  double Laplacian(double r) const { return r < h_ ? c_ * (h_ - r) : 0; }

 private:
  double h_;
  double c_;
};

}  // namespace sph
