// FNV-1a, 64 bits: a fingerprint of a state, to compare runs bit by bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace sph {

class Hash {
 public:
  /// Takes in the eight bytes of `value`, least significant first. +0 and -0 differ, as they do in the state.
  void Add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    Add(bits);
  }
  void Add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      state_ = (state_ ^ (bits & 0xff)) * 0x100000001b3ULL;
      bits >>= 8;
    }
  }
  void Add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) state_ = (state_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ULL;
  }
  std::uint64_t Value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace sph
