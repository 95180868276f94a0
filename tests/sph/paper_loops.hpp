// The paper's own loops (V-B, V-C), written as it describes them: a particle is a struct, cells are linked lists,
// neighbours and their distances are kept in arrays of fixed width. What fast code is measured against.
#pragma once

#include <cstdint>
#include <vector>

namespace sph {

class PaperLoops {
 public:
  /// Particles of equal mass at (x[i], y[i]) of a gas with P = k ((rho/rho0)^7 - 1).
  PaperLoops(const std::vector<double>& x, const std::vector<double>& y, double mass, double h, double k, double rho0);

  void ComputePressures();
  void AddSpatialInteraction();

  double Density(std::size_t i) const { return particles_[i].density; }
  double Ax(std::size_t i) const { return particles_[i].a[0]; }
  double Ay(std::size_t i) const { return particles_[i].a[1]; }

 private:
  static constexpr std::size_t kMostNeighbours = 128;

  struct Particle {
    float x[2], v[2], a[2];
    float pressure, density;
    float v_prev[2];
    std::uint32_t n;
    Particle* next;
  };

  void PrepareGrid();
  void FindCells(const float* r, int* cells) const;
  double Kernel(double r) const;
  double KernelSlope(double r) const;

  double mass_, h_, k_, rho0_;
  float x0_ = 0, y0_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<Particle> particles_;
  std::vector<Particle*> grid_;
  std::vector<std::uint16_t> neighbour_count_;
  std::vector<std::uint32_t> neighbour_;   // [particles][kMostNeighbours]
  std::vector<float> neighbour_distance_;  // [particles][kMostNeighbours]
};

}  // namespace sph
