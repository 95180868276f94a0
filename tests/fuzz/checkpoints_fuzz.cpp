// Any bytes as a checkpoint, as the state in one whose checksum is right, and as changes of such a state: read, or
// refused.
#include <algorithm>
#include <cstring>

#include "fuzz/fuzz.hpp"
#include "io/checkpoint.hpp"
#include "window/session.hpp"

namespace {

sph::SceneRequest FewParticles() {
  sph::SceneRequest request;
  request.particles = 40;
  request.threads = 1;
  return request;
}

std::vector<std::byte> StateOnTheWay() {
  constexpr int kSteps = 3;
  sph::Session session(FewParticles());
  for (int step = 0; step < kSteps; ++step) session.Step();
  std::vector<std::byte> state;
  sph::Archive archive = sph::Archive::Writer(state, sph::Archive::Extent::kSameBits);
  session.Transfer(archive);
  return state;
}

/// The state with a number written over it wherever the input says so: four bytes of the place, eight of the number.
std::vector<std::byte> Changed(std::vector<std::byte> state, std::span<const std::byte> input) {
  constexpr std::size_t kPlace = sizeof(std::uint32_t), kNumber = sizeof(std::uint64_t);
  for (; input.size() >= kPlace + kNumber; input = input.subspan(kPlace + kNumber)) {
    std::uint32_t place = 0;
    std::memcpy(&place, input.data(), kPlace);
    std::ranges::copy(input.subspan(kPlace, kNumber), state.begin() + place % (state.size() - kNumber + 1));
  }
  return state;
}

void Read(std::span<const std::byte> state) {
  sph::Session session(FewParticles());
  sph::RefusalIsFine([&] {
    sph::Archive archive = sph::Archive::Reader(state, sph::Archive::Extent::kSameBits);
    session.Transfer(archive);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<std::byte> state = StateOnTheWay();
  const auto bytes = std::as_bytes(std::span(data, size));
  sph::RefusalIsFine([&] { sph::DecodeCheckpoint(bytes, "the input"); });
  Read(bytes);
  Read(Changed(state, bytes));
  return 0;
}
