#include "sph/paper_loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.hpp"

namespace sph {

PaperLoops::PaperLoops(const std::vector<double>& x, const std::vector<double>& y, double mass, double h, double k,
                       double rho0)
    : mass_(mass), h_(h), k_(k), rho0_(rho0), particles_(x.size()) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    particles_[i] = {};
    particles_[i].x[0] = static_cast<float>(x[i]);
    particles_[i].x[1] = static_cast<float>(y[i]);
    particles_[i].n = static_cast<std::uint32_t>(i);
  }
  const auto [x_least, x_greatest] = std::minmax_element(x.begin(), x.end());
  const auto [y_least, y_greatest] = std::minmax_element(y.begin(), y.end());
  x0_ = static_cast<float>(*x_least);
  y0_ = static_cast<float>(*y_least);
  columns_ = static_cast<int>((*x_greatest - *x_least) / (2 * h)) + 2;
  rows_ = static_cast<int>((*y_greatest - *y_least) / (2 * h)) + 2;
  grid_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  neighbour_count_.resize(x.size());
  neighbour_.resize(x.size() * kMostNeighbours);
  neighbour_distance_.resize(x.size() * kMostNeighbours);
}

double PaperLoops::Kernel(double r) const {
  const double q = r / h_;
  const double c = 5 / (14 * std::numbers::pi * h_ * h_);
  if (q < 1) return c * (std::pow(2 - q, 3) - 4 * std::pow(1 - q, 3));
  return q < 2 ? c * std::pow(2 - q, 3) : 0;
}

double PaperLoops::KernelSlope(double r) const {
  const double q = r / h_;
  const double c = 5 / (14 * std::numbers::pi * h_ * h_ * h_);
  if (q < 1) return c * (12 * (1 - q) * (1 - q) - 3 * (2 - q) * (2 - q));
  return q < 2 ? c * -3 * (2 - q) * (2 - q) : 0;
}

void PaperLoops::PrepareGrid() {
  std::fill(grid_.begin(), grid_.end(), nullptr);
  for (Particle& particle : particles_) {
    const int column = static_cast<int>((particle.x[0] - x0_) / (2 * h_));
    const int row = static_cast<int>((particle.x[1] - y0_) / (2 * h_));
    Particle*& cell = grid_[static_cast<std::size_t>(row * columns_ + column)];
    particle.next = cell;
    cell = &particle;
  }
}

void PaperLoops::FindCells(const float* r, int* cells) const {
  const int column = static_cast<int>((r[0] - x0_) / (2 * h_));
  const int row = static_cast<int>((r[1] - y0_) / (2 * h_));
  for (int k = 0; k < 9; ++k) {
    const int c = column - 1 + k % 3;
    const int l = row - 1 + k / 3;
    cells[k] = c < 0 || c >= columns_ || l < 0 || l >= rows_ ? -1 : l * columns_ + c;
  }
}

void PaperLoops::ComputePressures() {
  PrepareGrid();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle& a = particles_[i];
    int cells[9];
    FindCells(a.x, cells);
    std::uint16_t count = 0;
    double density = 0;
    for (const int cell : cells) {
      if (cell < 0) continue;
      for (const Particle* b = grid_[static_cast<std::size_t>(cell)]; b != nullptr; b = b->next) {
        const double dx = static_cast<double>(a.x[0]) - b->x[0];
        const double dy = static_cast<double>(a.x[1]) - b->x[1];
        const double r = std::sqrt(dx * dx + dy * dy);
        if (r >= 2 * h_) continue;
        SPH_CHECK(count < kMostNeighbours, "{} neighbours", count);
        neighbour_[i * kMostNeighbours + count] = b->n;
        neighbour_distance_[i * kMostNeighbours + count] = static_cast<float>(r);
        ++count;
        density += mass_ * Kernel(r);
      }
    }
    neighbour_count_[i] = count;
    a.density = static_cast<float>(density);
    a.pressure = static_cast<float>(k_ * (std::pow(density / rho0_, 7) - 1));
  }
}

void PaperLoops::AddSpatialInteraction() {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    Particle& a = particles_[i];
    a.a[0] = a.a[1] = 0;
    for (std::size_t n = 0; n < neighbour_count_[i]; ++n) {
      const Particle& b = particles_[neighbour_[i * kMostNeighbours + n]];
      const double r = neighbour_distance_[i * kMostNeighbours + n];
      if (r == 0) continue;
      const double s =
          mass_ * (a.pressure / (a.density * a.density) + b.pressure / (b.density * b.density)) * KernelSlope(r) / r;
      for (int d = 0; d < 2; ++d) a.a[d] -= static_cast<float>(s * (static_cast<double>(a.x[d]) - b.x[d]));
    }
  }
}

}  // namespace sph
