// The fingerprint of a state: FNV-1a as its authors define it, so that no change of a single bit goes unseen.
#include "base/hash.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <string_view>

namespace sph {
namespace {

/// FNV-1a over bytes, as published (Fowler, Noll, Vo): offset basis and prime of 64 bits in decimal.
std::uint64_t PlainFnv1a(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  return hash;
}

template <typename T>
std::uint64_t HashOf(T value) {
  Hash hash;
  hash.Add(value);
  return hash.Value();
}

TEST(Hash, OfNothingIsTheOffsetBasis) { EXPECT_EQ(Hash().Value(), PlainFnv1a("")); }

TEST(Hash, IsFnv1aOfTheBytesLeastSignificantFirst) {
  ASSERT_EQ(PlainFnv1a("foobar"), 0x85944171f73967e8ULL);  // the authors' test vector: the twin is right
  const std::uint64_t number = 0x6867666564636261ULL;      // "abcdefgh"
  EXPECT_EQ(HashOf(number), PlainFnv1a("abcdefgh"));
  EXPECT_EQ(HashOf(std::bit_cast<double>(number)), PlainFnv1a("abcdefgh"));
}

// Each byte step (state ^ byte) * odd is one to one, so this holds for certain, not only with great probability.
RC_GTEST_PROP(Hash, SeesEverySingleBit, (std::uint64_t before, std::uint64_t bits, std::uint64_t after)) {
  const auto of = [&](std::uint64_t middle) {
    Hash hash;
    for (const std::uint64_t word : {before, middle, after}) hash.Add(std::bit_cast<double>(word));
    return hash.Value();
  };
  for (int bit = 0; bit < 64; ++bit) RC_ASSERT(of(bits) != of(bits ^ (1ULL << bit)));
}

TEST(Hash, TellsMinusZeroFromPlusZero) { EXPECT_NE(HashOf(0.0), HashOf(-0.0)); }

TEST(Hash, SeesTheOrder) {
  Hash ab, ba;
  ab.Add(1.0);
  ab.Add(2.0);
  ba.Add(2.0);
  ba.Add(1.0);
  EXPECT_NE(ab.Value(), ba.Value());
}

}  // namespace
}  // namespace sph
