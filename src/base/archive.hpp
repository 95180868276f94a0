// The state of an object as bytes: one function of its class, which names what the state is, both writes and reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace sph {

/// Either appends what it is given to bytes, or takes it back from them in the same order. Bytes are those of the
/// machine that wrote them.
class Archive {
 public:
  /// How much of the state is wanted.
  enum class Extent {
    kPhysics,  ///< what cannot be computed from the rest
    kSameBits  ///< and what a run needs to go on bit by bit as if it had never been written, such as neighbour lists
  };

  /// Appends to `bytes`, which must live as long.
  static Archive Writer(std::vector<std::byte>& bytes, Extent extent) { return {&bytes, {}, extent}; }
  /// Takes from `bytes`; TroubleError where they end too early or say what cannot be.
  static Archive Reader(std::span<const std::byte> bytes, Extent extent) { return {nullptr, bytes, extent}; }

  bool Reading() const { return written_ == nullptr; }
  Extent Wanted() const { return extent_; }
  /// Whether everything has been read.
  bool AtEnd() const { return rest_.empty(); }

  template <typename... Values>
  void operator()(Values&... values) {
    (One(values), ...);
  }

  /// For what has a meaning in certain states only, such as an index that must be in range.
  static void Require(bool consistent) {
    if (!consistent) throw TroubleError("the saved state contradicts itself");
  }

 private:
  Archive(std::vector<std::byte>* written, std::span<const std::byte> rest, Extent extent)
      : written_(written), rest_(rest), extent_(extent) {}

  /// Numbers and enumerators; a struct goes member by member, because what lies between its members has no value.
  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void One(T& value) {
    Bytes(&value, sizeof value);
    if constexpr (std::is_same_v<T, bool>) {
      unsigned char byte = 0;
      std::memcpy(&byte, &value, 1);
      Require(byte <= 1);
    }
  }
  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void One(std::vector<T>& values) {
    values.resize(Count(values.size(), sizeof(T)));
    Bytes(values.data(), values.size() * sizeof(T));
  }
  void One(std::string& text) {
    text.resize(Count(text.size(), 1));
    Bytes(text.data(), text.size());
  }
  void One(std::vector<std::string>& texts) {
    texts.resize(Count(texts.size(), sizeof(std::uint64_t)));
    for (std::string& text : texts) One(text);
  }
  template <typename T>
  void One(std::optional<T>& value) {
    bool has = value.has_value();
    One(has);
    if (!has) value.reset();
    if (has && !value) value.emplace();
    if (has) One(*value);
  }

  /// The number of things that follow, of at least so many bytes each.
  std::size_t Count(std::size_t count, std::size_t least) {
    std::uint64_t number = count;
    One(number);
    Require(!Reading() || number <= rest_.size() / least);
    return number;
  }

  void Bytes(void* data, std::size_t size) {
    if (size == 0) return;
    if (!Reading()) {
      const auto* first = static_cast<const std::byte*>(data);
      written_->insert(written_->end(), first, first + size);
      return;
    }
    Require(size <= rest_.size());
    std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::vector<std::byte>* written_;
  std::span<const std::byte> rest_;
  Extent extent_;
};

}  // namespace sph
