// Positions as the passes over neighbours read them: exact differences at any size of the domain, in either precision.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace sph {

/// Vector loads may go beyond the last particle by less than this many.
inline constexpr std::size_t kPadding = 64;

/// For passes in double: multiples of the power of two nearest below the support (an exact conversion). For passes in
/// float: whole multiples of support/2^28, modulo 2^32. Their differences are exact, so that a distance has float's
/// relative precision wherever the particles are; a float coordinate would lose it far from the origin. The modulus
/// does no harm where the particles that are compared lie within 8 supports of each other.
template <typename Real>
class Positions {
 public:
  using Coordinate = std::conditional_t<std::is_same_v<Real, float>, std::int32_t, double>;

  /// Length of a unit of the coordinates [m].
  static double Unit(double support) {
    if constexpr (std::is_same_v<Real, float>) return support * 0x1.0p-28;
    return std::exp2(std::floor(std::log2(support)));
  }

  /// A position [m] as a coordinate.
  static Coordinate ToCoordinate(double position, double per_unit) {
    if constexpr (std::is_same_v<Real, float>) {
      // Adding 1.5 * 2^52 rounds to a whole number and leaves it, modulo 2^32, in the lower half of the bits.
      const double rounded = position * per_unit + 0x1.8p52;
      std::uint64_t bits = 0;
      std::memcpy(&bits, &rounded, sizeof bits);
      return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
    } else {
      return position * per_unit;
    }
  }

  /// Room for n particles and the padding, whose values are of no meaning, but finite.
  void Resize(std::size_t n) {
    x_.resize(n + kPadding);
    y_.resize(n + kPadding);
  }
  /// Takes the positions [m] of the particles first ... last - 1.
  void Set(std::span<const double> x, std::span<const double> y, double support, std::size_t first, std::size_t last) {
    const double per_unit = 1 / Unit(support);
    for (std::size_t i = first; i < last; ++i) {
      x_[i] = ToCoordinate(x[i], per_unit);
      y_[i] = ToCoordinate(y[i], per_unit);
    }
  }

  /// Takes the positions of images and wall particles [m], behind those of n particles.
  void SetImages(std::span<const double> x, std::span<const double> y, double support, std::size_t n) {
    const double per_unit = 1 / Unit(support);
    for (std::size_t k = 0; k < x.size(); ++k) {
      x_[n + k] = ToCoordinate(x[k], per_unit);
      y_[n + k] = ToCoordinate(y[k], per_unit);
    }
  }

  const Coordinate* X() const { return x_.data(); }
  const Coordinate* Y() const { return y_.data(); }
  std::size_t Bytes() const { return sizeof(Coordinate) * (x_.capacity() + y_.capacity()); }

 private:
  std::vector<Coordinate> x_;
  std::vector<Coordinate> y_;
};

}  // namespace sph
