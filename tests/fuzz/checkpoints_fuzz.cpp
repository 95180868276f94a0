// Any bytes as a checkpoint, and as the state in one whose checksum is right: read, or refused.
#include "fuzz/fuzz.hpp"
#include "io/checkpoint.hpp"
#include "window/session.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sph;
  const auto bytes = std::as_bytes(std::span(data, size));
  RefusalIsFine([&] { DecodeCheckpoint(bytes, "the input"); });
  SceneRequest request;
  request.particles = 40;
  request.threads = 1;
  Session session(request);
  RefusalIsFine([&] {
    Archive archive = Archive::Reader(bytes, Archive::Extent::kSameBits);
    session.Transfer(archive);
  });
  return 0;
}
