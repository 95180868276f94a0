#include "lab/scalar_twin.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sph {
namespace {

/// Particles by square cells as wide as the support; cells far apart may share a bucket.
class Buckets {
 public:
  Buckets(const Particles& particles, double support) : support_(support), begin_(particles.Size() + 2) {
    std::vector<std::size_t> bucket(particles.Size());
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      bucket[i] = Of(Cell(particles.x[i]), Cell(particles.y[i]));
      ++begin_[bucket[i] + 1];
    }
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    particles_.resize(bucket.size());
    std::vector<std::size_t> next = begin_;
    for (std::size_t i = 0; i < bucket.size(); ++i) particles_[next[bucket[i]]++] = i;
  }

  /// Calls use(j) for every particle that may be within the support of `point`.
  template <typename Use>
  void ForEachNear(Vec2 point, Use use) const {
    std::array<std::size_t, 9> near;
    for (std::size_t k = 0; k < near.size(); ++k) {
      near[k] = Of(Cell(point.x) + static_cast<long>(k % 3) - 1, Cell(point.y) + static_cast<long>(k / 3) - 1);
    }
    std::sort(near.begin(), near.end());
    const auto end = std::unique(near.begin(), near.end());  // each bucket once
    for (auto b = near.begin(); b != end; ++b) {
      for (std::size_t k = begin_[*b]; k < begin_[*b + 1]; ++k) use(particles_[k]);
    }
  }

 private:
  long Cell(double coordinate) const { return std::lround(std::floor(coordinate / support_)); }
  std::size_t Of(long column, long row) const {
    const auto hash = static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(row);
    return hash % (begin_.size() - 1);
  }

  double support_;
  std::vector<std::size_t> begin_;  // [buckets + 1]
  std::vector<std::size_t> particles_;
};

class ScalarTwin {
 public:
  explicit ScalarTwin(const ParticleSystemSPH& system)
      : system_(system),
        kernel_(system.parameters_sph.smoothing_length),
        buckets_(system.State(), system.Support()),
        density_(system.State().Size(), -1) {}

  double Density(std::size_t i) {
    if (density_[i] < 0) {
      density_[i] = 0;
      ForEachNeighbour(
          i, [&](std::size_t j, Vec2, double r) { density_[i] += system_.State().mass[j] * kernel_.Value(r); });
    }
    return density_[i];
  }

  Vec2 Acceleration(std::size_t i) {
    Vec2 sum = system_.parameters.gravity;
    ForEachNeighbour(i, [&](std::size_t j, Vec2 apart, double r) {
      const double push = -system_.State().mass[j] * (Term(i) + Term(j)) * kernel_.Gradient(r);
      sum = sum + push * apart;
    });
    return sum;
  }

 private:
  /// P/rho^2
  double Term(std::size_t i) {
    const double rho = Density(i);
    const auto pressure = [&](const auto& equation_of_state) { return equation_of_state.Pressure(rho); };
    return std::visit(pressure, system_.parameters_sph.equation_of_state) / (rho * rho);
  }

  /// Calls use(j, x_i - x_j, its length) for every particle j in the support of i, i itself too.
  template <typename Use>
  void ForEachNeighbour(std::size_t i, Use use) const {
    const Particles& p = system_.State();
    buckets_.ForEachNear(p.Position(i), [&](std::size_t j) {
      const Vec2 apart = p.Position(i) - p.Position(j);
      const double r = Length(apart);
      if (r < system_.Support()) use(j, apart, r);
    });
  }

  const ParticleSystemSPH& system_;
  CubicSpline<2> kernel_;
  Buckets buckets_;
  std::vector<double> density_;  // -1 where not known yet
};

}  // namespace

FieldErrors ErrorsAgainstScalarTwin(const ParticleSystemSPH& system, std::size_t samples) {
  ScalarTwin twin(system);
  const std::vector<double> density = system.Density();
  const Particles& p = system.State();
  const std::size_t stride = std::max<std::size_t>(1, p.Size() / samples);
  FieldErrors greatest;
  FieldErrors errors;
  for (std::size_t i = 0; i < p.Size(); i += stride) {
    const Vec2 acceleration = twin.Acceleration(i);
    greatest.density = std::max(greatest.density, twin.Density(i));
    greatest.acceleration = std::max(greatest.acceleration, Length(acceleration));
    errors.density = std::max(errors.density, std::abs(density[i] - twin.Density(i)));
    errors.acceleration = std::max(errors.acceleration, Length(Vec2{p.ax[i], p.ay[i]} - acceleration));
  }
  return {errors.density / greatest.density, errors.acceleration / greatest.acceleration};
}

}  // namespace sph
