#include "particles/particles.hpp"

#include "base/check.hpp"

namespace sph {
namespace {

template <typename T>
void Gather(std::vector<T>& values, std::span<const std::uint32_t> order, std::vector<T>& scratch, int threads) {
  constexpr std::size_t kParticlesOfOneThread = 8192;  // waking the others costs more than so little work
  scratch.resize(values.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (order.size() > kParticlesOfOneThread)
  for (std::size_t k = 0; k < order.size(); ++k) scratch[k] = values[order[k]];
  values.swap(scratch);
}

}  // namespace

void Particles::Reserve(std::size_t n) {
  for (auto* component : {&x, &y, &vx, &vy, &vx_prev, &vy_prev, &ax, &ay, &mass}) component->reserve(n);
  id.reserve(n);
}

void Particles::Add(Vec2 position, Vec2 velocity, double particle_mass) {
  id.push_back(static_cast<std::uint32_t>(Size()));
  x.push_back(position.x);
  y.push_back(position.y);
  for (auto* component : {&vx, &vx_prev}) component->push_back(velocity.x);
  for (auto* component : {&vy, &vy_prev}) component->push_back(velocity.y);
  for (auto* component : {&ax, &ay}) component->push_back(0.0);
  mass.push_back(particle_mass);
}

void Particles::Clear() {
  for (auto* component : {&x, &y, &vx, &vy, &vx_prev, &vy_prev, &ax, &ay, &mass}) component->clear();
  id.clear();
}

std::size_t Particles::Bytes() const {
  std::size_t bytes =
      sizeof(std::uint32_t) * (id.capacity() + id_scratch_.capacity()) + sizeof(double) * scratch_.capacity();
  for (const auto* component : {&x, &y, &vx, &vy, &vx_prev, &vy_prev, &ax, &ay, &mass}) {
    bytes += sizeof(double) * component->capacity();
  }
  return bytes;
}

void Particles::Reorder(std::span<const std::uint32_t> order, int threads) {
  SPH_CHECK(order.size() == Size(), "{} places for {} particles", order.size(), Size());
  for (auto* component : {&x, &y, &vx, &vy, &vx_prev, &vy_prev, &ax, &ay, &mass}) {
    Gather(*component, order, scratch_, threads);
  }
  Gather(id, order, id_scratch_, threads);
}

void Particles::Transfer(Archive& archive) {
  archive(x, y, vx, vy, vx_prev, vy_prev, mass, id);
  for (const auto* component : {&y, &vx, &vy, &vx_prev, &vy_prev, &mass}) Archive::Require(component->size() == Size());
  Archive::Require(id.size() == Size());
  ax.resize(Size());
  ay.resize(Size());
}

}  // namespace sph
